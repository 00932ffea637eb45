#include "simcore/experiment/worker_pool.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include "simcore/base/text.h"
#include "simcore/io/atomic_file.h"

extern char** environ;

namespace simcore::experiment {
namespace {

/// A process with pipes to and from it; killed and waited for with its object.
class Worker {
  public:
    /// 0, or an error number.
    int start(const std::vector<std::string>& command) {
        std::array<int, 2> in{};
        std::array<int, 2> out{};
        if (pipe2(in.data(), O_CLOEXEC) != 0) {
            return errno;
        }
        if (pipe2(out.data(), O_CLOEXEC) != 0) {
            const int error = errno;
            close(in[0]);
            close(in[1]);
            return error;
        }
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
        std::vector<char*> arguments;
        for (const std::string& argument : command) {
            arguments.push_back(const_cast<char*>(argument.c_str()));  // NOLINT: posix_spawn's way
        }
        arguments.push_back(nullptr);
        const int error =
            posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        close(in[0]);
        close(out[1]);
        in_ = in[1];
        out_ = out[0];
        if (error != 0) {
            process_ = -1;
        }
        return error;
    }

    Worker() = default;
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    ~Worker() {
        if (in_ >= 0) {
            close(in_);
            close(out_);
        }
        if (process_ > 0) {
            kill(process_, SIGKILL);
            waitpid(process_, nullptr, 0);
        }
    }

    bool send(const std::string& line) { return io::writeAll(in_, line + "\n"); }

    int output() const { return out_; }

    /// Reads what there is. False at its end.
    bool read() {
        std::array<char, 65536> buffer;
        const ssize_t count = ::read(out_, buffer.data(), buffer.size());
        if (count > 0) {
            text_.append(buffer.data(), static_cast<std::size_t>(count));
        }
        return count > 0 || (count < 0 && errno == EINTR);
    }

    std::optional<std::string> takeLine() {
        const std::size_t end = text_.find('\n');
        if (end == std::string::npos) {
            return std::nullopt;
        }
        std::string line = text_.substr(0, end);
        text_.erase(0, end + 1);
        return line;
    }

    std::optional<std::size_t> task;

  private:
    pid_t process_ = -1;
    int in_ = -1;
    int out_ = -1;
    std::string text_;
};

/// A write to a worker that has ended is an error here, not the end of this process.
class IgnoredPipeSignal {
  public:
    IgnoredPipeSignal() {
        struct sigaction ignore {};

        ignore.sa_handler = SIG_IGN;
        sigaction(SIGPIPE, &ignore, &before_);
    }

    ~IgnoredPipeSignal() { sigaction(SIGPIPE, &before_, nullptr); }

    IgnoredPipeSignal(const IgnoredPipeSignal&) = delete;
    IgnoredPipeSignal& operator=(const IgnoredPipeSignal&) = delete;

  private:
    struct sigaction before_ {};
};

class Pool {
  public:
    Pool(const std::vector<std::string>& command, const std::string& greeting,
         const std::vector<std::string>& tasks)
        : command_(command),
          greeting_(greeting),
          tasks_(tasks) {}

    /// Starts a worker in this place and gives it its first task.
    int startWorker(std::unique_ptr<Worker>& place) {
        place.reset();
        if (next_ == tasks_.size()) {
            return 0;
        }
        place = std::make_unique<Worker>();
        if (const int error = place->start(command_); error != 0) {
            place.reset();
            return error;
        }
        place->send(greeting_);
        give(*place);
        return 0;
    }

    /// What a worker that ended does not read shows when its output is read.
    void give(Worker& worker) {
        worker.task.reset();
        if (next_ < tasks_.size()) {
            worker.task = next_++;
            worker.send(tasks_[*worker.task]);
        }
    }

  private:
    const std::vector<std::string>& command_;
    const std::string& greeting_;
    const std::vector<std::string>& tasks_;
    std::size_t next_ = 0;
};

}  // namespace

Result<bool> runInWorkers(
    const std::vector<std::string>& command, const std::string& greeting,
    const std::vector<std::string>& tasks, int jobs,
    const std::function<bool(std::size_t, const std::optional<std::string>&)>& answered) {
    const IgnoredPipeSignal ignored;
    Pool pool(command, greeting, tasks);
    std::vector<std::unique_ptr<Worker>> workers(
        std::min(static_cast<std::size_t>(std::max(1, jobs)), tasks.size()));
    const auto cannotStart = [&](int error) {
        return Problem{Severity::Critical, Text::of("worker {}", command.front()),
                       Text::of("it cannot be started: {}.", std::strerror(error)),
                       Text::of("Free memory or processes, or use fewer jobs.")};
    };
    for (std::unique_ptr<Worker>& worker : workers) {
        if (const int error = pool.startWorker(worker); error != 0) {
            return cannotStart(error);
        }
    }
    while (true) {
        std::vector<pollfd> waiting;
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < workers.size(); ++i) {
            if (workers[i] && workers[i]->task) {
                waiting.push_back({workers[i]->output(), POLLIN, 0});
                places.push_back(i);
            }
        }
        if (waiting.empty()) {
            return true;
        }
        poll(waiting.data(), waiting.size(), -1);
        for (std::size_t k = 0; k < waiting.size(); ++k) {
            if (waiting[k].revents == 0) {
                continue;
            }
            std::unique_ptr<Worker>& worker = workers[places[k]];
            const bool lives = worker->read();
            std::optional<std::string> answer = worker->takeLine();
            if (lives && !answer) {
                continue;
            }
            if (!answered(*worker->task, answer)) {
                return true;
            }
            if (lives) {
                pool.give(*worker);
            } else if (const int error = pool.startWorker(worker); error != 0) {
                return cannotStart(error);
            }
        }
    }
}

}  // namespace simcore::experiment
