// SPDX-License-Identifier: BSL-1.0
#include "engine/machine_code/c_library.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace engine {

namespace {

namespace files = std::filesystem;

/// Products are not contracted, and no value is assumed to be finite.
constexpr std::array always{"-shared", "-fPIC", "-ffp-contract=off", "-fno-math-errno", "-fno-semantic-interposition", "-x", "c"};

std::optional<std::string> content(files::path const& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream all;
    if (not in or not(all << in.rdbuf())) return {};
    return all.str();
}
std::string hash_of(std::string const& text) { // Fowler, Noll, Vo, twice
    std::ostringstream out;
    for (std::uint64_t hash : {0xcbf29ce484222325U, 0x84222325cbf29ce4U}) {
        for (unsigned char const c : text) hash = (hash ^ c) * 0x100000001b3U;
        out << std::hex << hash;
    }
    return out.str();
}
/// A folder that only this user can write to, created if missing; nothing when that fails.
std::optional<files::path> folder() {
    files::path path;
    if (auto const cache = environment_variable("XDG_CACHE_HOME"))
        path = *cache;
    else if (auto const home = environment_variable("HOME"))
        path = files::path(*home) / ".cache";
    else
        return {};
    path /= "hilger";
    std::error_code failed;
    files::create_directories(path.parent_path(), failed);
    if (::mkdir(path.c_str(), 0700) != 0 and errno != EEXIST) return {};
    struct stat about {};
    if (::stat(path.c_str(), &about) != 0 or about.st_uid != ::geteuid() or (about.st_mode & (S_IWGRP | S_IWOTH)) != 0) return {};
    return path;
}
/// The number of libraries kept in the folder, each with its text.
constexpr std::size_t most_kept = 256;
/// Removes the oldest files, and those left by killed processes. Another process may do the same, or use a removed library: it has loaded
/// it, or compiles it again.
void forget_the_oldest(files::path const& where) {
    std::error_code never_mind;
    std::vector<std::pair<files::file_time_type, files::path>> all;
    for (files::directory_iterator at(where, never_mind), end; at != end; at.increment(never_mind))
        all.emplace_back(files::last_write_time(at->path(), never_mind), at->path());
    if (all.size() <= 2 * most_kept) return;
    std::sort(all.begin(), all.end());
    all.resize(all.size() - 2 * most_kept);
    for (auto const& [when, path] : all) files::remove(path, never_mind);
}
/// The text with the options in it, so that the hash covers both.
std::string with_options(std::string text, std::vector<std::string> const& options) {
    std::string said;
    for (std::string const& option : options) said += option + ' ';
    return "/* " + said + "*/\n" + std::move(text);
}

} // namespace

std::optional<std::string> environment_variable(char const* name) {
    char const* const value = std::getenv(name);
    if (value == nullptr or *value == '\0') return {};
    return value;
}

c_library::c_library(std::string text, std::vector<std::string> options)
    : text_(with_options(std::move(text), options)), options_(std::move(options)), owner_(::getpid()) {}

c_library::~c_library() {
    if (process_ <= 0 or owner_ != ::getpid()) return;
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
    forget_files();
}

c_library::status c_library::look(bool wait) {
    if (process_ == 0 and result_ == status::working) begin();
    if (process_ > 0) {
        int code = 0;
        if (auto const ended = ::waitpid(process_, &code, wait ? 0 : WNOHANG); ended != 0) {
            process_ = -1;
            if (ended > 0 and WIFEXITED(code) and WEXITSTATUS(code) == 0)
                finish();
            else
                result_ = ended > 0 and WIFEXITED(code) and WEXITSTATUS(code) == 127 ? status::no_compiler : status::failed;
            forget_files();
        }
    }
    return result_;
}

void* c_library::find(std::string const& name) const { return loaded_ == nullptr ? nullptr : ::dlsym(loaded_, name.c_str()); }

void c_library::begin() {
    auto const where = folder();
    if (not where) {
        result_ = status::failed;
        return;
    }
    kept_ = *where / hash_of(text_);
    library_ = kept_;
    library_ += ".so";
    source_ = kept_;
    source_ += ".c";
    if (auto const kept = content(source_); kept and files::exists(library_)) {
        if (*kept != text_) result_ = status::failed; // another text with this hash
        if (result_ == status::failed or load()) return;
    }
    std::string const own = '.' + std::to_string(::getpid()) + '.' + std::to_string(reinterpret_cast<std::uintptr_t>(this));
    own_source_ = kept_;
    own_source_ += own + ".c";
    own_library_ = kept_;
    own_library_ += own + ".so";
    std::ofstream out(own_source_, std::ios::binary);
    out << text_;
    out.close();
    if (not out)
        result_ = status::failed;
    else
        spawn();
}

void c_library::spawn() {
    std::vector<std::string> words;
    std::istringstream compiler(environment_variable("CC").value_or("cc"));
    for (std::string word; compiler >> word;) words.push_back(word);
    if (words.empty()) words.emplace_back("cc");
    words.insert(words.end(), options_.begin(), options_.end());
    words.insert(words.end(), always.begin(), always.end());
    for (std::string const& word : {own_source_.string(), std::string("-o"), own_library_.string(), std::string("-lm")})
        words.push_back(word);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t quiet;
    ::posix_spawn_file_actions_init(&quiet);
    for (int const stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", stream == STDIN_FILENO ? O_RDONLY : O_WRONLY, 0);
    int const failure = ::posix_spawnp(&process_, arguments.front(), &quiet, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&quiet);
    if (failure != 0) {
        process_ = -1;
        result_ = status::no_compiler;
        forget_files();
    }
}

/// Moves the text first: a library without its text is not used.
void c_library::finish() {
    std::error_code failed;
    files::rename(own_source_, source_, failed);
    if (not failed) files::rename(own_library_, library_, failed);
    if (failed or not load()) result_ = status::failed;
    forget_the_oldest(kept_.parent_path());
}

bool c_library::load() {
    loaded_ = ::dlopen(library_.c_str(), RTLD_NOW | RTLD_LOCAL); // never unloaded: another thread may be running it when the program ends
    if (loaded_ == nullptr) return false;
    result_ = status::done;
    std::error_code never_mind;
    for (auto const& used : {source_, library_}) files::last_write_time(used, files::file_time_type::clock::now(), never_mind);
    return true;
}

void c_library::forget_files() {
    std::error_code never_mind;
    files::remove(own_source_, never_mind);
    files::remove(own_library_, never_mind);
}

} // namespace engine
