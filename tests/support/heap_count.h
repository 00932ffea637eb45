#pragma once

namespace testsupport {

/// How often this program has asked the heap for memory, in whatever way: operator new and Eigen
/// both come to malloc. Zero with sanitizers, which bring a heap of their own.
long heapCount();

/// Whether heapCount() counts.
bool heapIsCounted();

}  // namespace testsupport
