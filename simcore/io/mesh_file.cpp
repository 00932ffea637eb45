// Meshes through assimp, in a process of its own.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>

#include "simcore/base/text.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/terrain_file.h"

namespace simcore::io {
namespace {

constexpr rlim_t kMostSeconds = 5;
constexpr rlim_t kMostMemory = rlim_t{1} << 30U;

/// Formats that are offered; assimp knows some fifty more, hardly any of them proven.
constexpr std::array kFormats{"obj", "stl", "ply", "dae", "glb", "off", "3ds"};

/// What the child sends before vertices and triangles.
struct Reply {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
    std::uint64_t messageSize = 0;
};

/// Memory that this process has mapped [byte].
rlim_t mappedNow() {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void limitThisProcess(rlim_t mapped) {
    const rlimit seconds{kMostSeconds, kMostSeconds};
    setrlimit(RLIMIT_CPU, &seconds);
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
#ifndef __SANITIZE_ADDRESS__  // whose shadow memory is larger than any limit
    const rlimit memory{mapped + kMostMemory, mapped + kMostMemory};
    setrlimit(RLIMIT_AS, &memory);
#endif
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU}) {
        std::signal(signal, SIG_DFL);
    }
    // What assimp or the C++ library have to say on the way out concerns nobody.
    if (std::freopen("/dev/null", "w", stderr) == nullptr) {
        return;
    }
}

bool sendAll(int pipe, const void* data, std::size_t size) {
    return writeAll(pipe, {static_cast<const char*>(data), size});
}

bool receiveAll(int pipe, void* data, std::size_t size) {
    auto* at = static_cast<char*>(data);
    while (size > 0) {
        const ssize_t got = read(pipe, at, size);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got <= 0) {
            return false;
        }
        at += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

/// All triangles of a scene whose parts have been placed.
terrain::TriangleMesh meshOf(const aiScene& scene) {
    terrain::TriangleMesh all;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        const auto first = static_cast<int>(all.vertices.size());
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D& v = mesh.mVertices[i];
            all.vertices.emplace_back(v.x, v.y, v.z);
        }
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace& face = mesh.mFaces[i];
            if (face.mNumIndices == 3) {
                all.triangles.push_back({first + static_cast<int>(face.mIndices[0]),
                                         first + static_cast<int>(face.mIndices[1]),
                                         first + static_cast<int>(face.mIndices[2])});
            }
        }
    }
    return all;
}

/// Further files that a mesh names, such as materials: none. It must not make the program read what
/// its author chose, a pipe for instance that never ends.
class NoOtherFiles final : public Assimp::IOSystem {
  public:
    bool Exists(const char* /*file*/) const override { return false; }

    char getOsSeparator() const override { return '/'; }

    Assimp::IOStream* Open(const char* /*file*/, const char* /*mode*/) override { return nullptr; }

    void Close(Assimp::IOStream* /*stream*/) override {}
};

/// The child's work: reads and sends the mesh, or why there is none; marked, as after a fork
/// nothing can be looked up.
void importAndSend(std::span<const std::byte> bytes, const std::string& extension, int pipe) {
    Assimp::Importer importer;
    importer.SetIOHandler(new NoOtherFiles);  // the importer's from now on
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFileFromMemory(
        bytes.data(), bytes.size(),
        aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_PreTransformVertices,
        extension.c_str());
    std::string message;
    terrain::TriangleMesh mesh;
    if (scene == nullptr) {
        message = importer.GetErrorString();
    } else {
        mesh = meshOf(*scene);
        if (mesh.triangles.empty()) {
            message = Text::mark("there are no triangles in it");
        } else if (mesh.triangles.size() > terrain::kMostMeshTriangles) {
            message = Text::mark("there are too many triangles in it");
        }
    }
    if (!message.empty()) {
        mesh = {};
    }
    const Reply reply{mesh.vertices.size(), mesh.triangles.size(), message.size()};
    sendAll(pipe, &reply, sizeof reply) && sendAll(pipe, message.data(), message.size()) &&
        sendAll(pipe, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3)) &&
        sendAll(pipe, mesh.triangles.data(), mesh.triangles.size() * sizeof(std::array<int, 3>));
}

/// True when a whole reply came that keeps its own promises.
bool receiveMesh(int pipe, terrain::TriangleMesh& mesh, std::string& message) {
    Reply reply;
    constexpr std::uint64_t kLongestMessage = 100'000;
    if (!receiveAll(pipe, &reply, sizeof reply) || reply.messageSize > kLongestMessage ||
        reply.triangles > terrain::kMostMeshTriangles ||
        reply.vertices > 8 * terrain::kMostMeshTriangles) {
        return false;
    }
    message.resize(reply.messageSize);
    mesh.vertices.resize(reply.vertices);
    mesh.triangles.resize(reply.triangles);
    if (!receiveAll(pipe, message.data(), message.size()) ||
        !receiveAll(pipe, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vec3)) ||
        !receiveAll(pipe, mesh.triangles.data(),
                    mesh.triangles.size() * sizeof(std::array<int, 3>))) {
        return false;
    }
    for (const auto& triangle : mesh.triangles) {
        for (const int k : triangle) {
            if (k < 0 || k >= static_cast<int>(mesh.vertices.size())) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

Result<terrain::TriangleMesh> readMesh(std::span<const std::byte> bytes,
                                       const std::string& extension, const std::string& name) {
    const auto problem = [&](std::string reason, std::string remedy) {
        return Problem{Severity::Critical, name, std::move(reason), std::move(remedy)};
    };
    std::string format = extension;
    for (char& c : format) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    if (std::find(kFormats.begin(), kFormats.end(), format) == kFormats.end()) {
        return problem(Text::of("'{}' is not a kind of mesh that is read.", extension),
                       Text::of("Use one of: {}.", fmt::join(kFormats, ", ")));
    }
    const rlim_t mapped = mappedNow();
    int ends[2];
    if (pipe(ends) != 0) {
        return problem(Text::of("no process can be started to read it."),
                       Text::of("Close other programs."));
    }
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        limitThisProcess(mapped);
        try {
            importAndSend(bytes, format, ends[1]);
        } catch (...) {
            _exit(1);  // no reply says enough
        }
        _exit(0);  // without the destructors of the program that was copied
    }
    close(ends[1]);
    terrain::TriangleMesh mesh;
    std::string message;
    const bool whole = child > 0 && receiveMesh(ends[0], mesh, message);
    close(ends[0]);
    if (child < 0) {
        return problem(Text::of("no process can be started to read it."),
                       Text::of("Close other programs."));
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!whole) {
        return problem(
            Text::of(
                "the mesh reader gave up: the file is broken, or takes more than 5 s or 1 GiB."),
            Text::of("Check it in a mesh editor, simplify it, or write it in another format."));
    }
    if (!message.empty()) {
        return problem(Text::of("the mesh cannot be read ({}).", Text::translated(message.c_str())),
                       Text::of("Check the file; obj, stl and ply are the safest formats."));
    }
    return mesh;
}

}  // namespace simcore::io
