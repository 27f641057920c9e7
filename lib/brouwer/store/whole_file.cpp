#include <brouwer/store/whole_file.hpp>

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <brouwer/error.hpp>

namespace brouwer {
namespace {

namespace fs = std::filesystem;

std::string const temporary_prefix = ".tmp-";

[[noreturn]] void fail(char const* doing, fs::path const& what, int error) {
  throw RunError(fmt::format("cannot {} {}: {}", doing, what.string(), std::generic_category().message(error)));
}

/// An open file, closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() { close(); }

  explicit operator bool() const { return fd_ >= 0; }
  int operator*() const { return fd_; }

  /// 0, or -1 with errno: a network file system may report a full disk only here.
  int close() { return fd_ < 0 ? 0 : ::close(std::exchange(fd_, -1)); }

 private:
  int fd_;
};

/// Opens the temporary and locks it, so that remove_leftovers of another process sees that it is in use.
/// Between the two calls that process may have taken it for a leftover: then it has no name any more.
Descriptor open_locked(fs::path const& temporary) {
  for (;;) {
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file) return file;
    ::flock(*file, LOCK_EX);  // where locks do not exist, nobody else can lock either, and leftovers stay
    struct stat status = {};
    if (::fstat(*file, &status) == 0 && status.st_nlink > 0) return file;
  }
}

/// The file under its temporary name; unless it is renamed, it is removed.
class Temporary {
 public:
  explicit Temporary(fs::path goal) : goal_(std::move(goal)), path_(unique_name(goal_)), file_(open_locked(path_)) {
    while (!file_ && errno == EEXIST) {  // of a dead process with our number, or of one on another machine
      path_ = unique_name(goal_);
      file_ = open_locked(path_);
    }
    if (!file_) fail("write", goal_, errno);
  }
  ~Temporary() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  Temporary(Temporary const&) = delete;
  Temporary& operator=(Temporary const&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      ssize_t const written = ::write(*file_, bytes.data(), bytes.size());
      if (written < 0 && errno != EINTR) fail("write", goal_, errno);
      if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void rename() {
    if (::fsync(*file_) != 0) fail("write", goal_, errno);
    if (::rename(path_.c_str(), goal_.c_str()) != 0) fail("write", goal_, errno);
    path_.clear();
    if (file_.close() != 0) fail("write", goal_, errno);
  }

 private:
  static fs::path unique_name(fs::path const& goal) {
    static std::atomic<unsigned> count = 0;
    return goal.parent_path() /
           fmt::format("{}{}-{}-{}", temporary_prefix, ::getpid(), count++, goal.filename().string());
  }

  fs::path goal_, path_;
  Descriptor file_;
};

/// Removes `file` unless the process that writes it still lives, and with it its lock.
void remove_if_unlocked(fs::path const& file) {
  Descriptor const opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  if (opened && ::flock(*opened, LOCK_EX | LOCK_NB) == 0) ::unlink(file.c_str());
}

}  // namespace

void write_whole(fs::path const& file, std::string_view bytes) {
  Temporary temporary(file);
  temporary.write(bytes);
  temporary.rename();
  sync_folder(file.parent_path());
}

void sync_folder(fs::path const& folder) {
  Descriptor const opened(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!opened || (::fsync(*opened) != 0 && errno != EINVAL)) fail("write into", folder, errno);
}

bool is_leftover(fs::path const& file) { return file.filename().string().starts_with(temporary_prefix); }

void remove_leftovers(fs::path const& folder) {
  std::error_code none;
  auto entry = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, none);
  for (; !none && entry != fs::recursive_directory_iterator(); entry.increment(none))
    if (is_leftover(entry->path()) && entry->is_regular_file(none)) remove_if_unlocked(entry->path());
}

std::string read_whole(fs::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || (!(text << stream.rdbuf()) && stream.peek() != std::ifstream::traits_type::eof()))
    fail("read", file, errno);
  return text.str();
}

}  // namespace brouwer
