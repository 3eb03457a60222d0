// SPDX-License-Identifier: BSL-1.0
// A translation is text, a file, a process of the compiler and a library that is loaded, in this order; each step waits for nothing but is
// looked at again when the formula has been evaluated often again. What is compiled is kept under the name of its text's hash in the user's
// folder for such things, with the text beside it, which is compared: a hash is no proof.
#include "engine/machine_code.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

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
using evaluation = hilger::detail::evaluation<double>;
using translation = hilger::detail::translation<double>;
using functions = std::array<translation::function, translation::functions>;

/// No products are contracted, nothing is folded and no two functions are joined to a third one: all of it would round differently.
constexpr std::array options{"-O2",
                             "-ftree-vectorize",
                             "-shared",
                             "-fPIC",
                             "-ffp-contract=off",
                             "-fno-math-errno",
                             "-fno-semantic-interposition",
                             "-fno-builtin-sin",
                             "-fno-builtin-cos",
                             "-x",
                             "c"};

std::optional<std::string> variable(char const* name) {
    char const* const value = std::getenv(name);
    if (value == nullptr or *value == '\0') return {};
    return value;
}
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
/// A folder that is this user's and nobody else's to write into, made where it is not there; nothing where that cannot be.
std::optional<files::path> folder() {
    files::path path;
    if (auto const cache = variable("XDG_CACHE_HOME"))
        path = *cache;
    else if (auto const home = variable("HOME"))
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

/// The compiler at work on one text.
class job {
public:
    explicit job(std::string text) : text_(std::move(text)) {}
    job(job const&) = delete;
    job& operator=(job const&) = delete;
    /// A compiler that nobody waits for any more ends, and leaves nothing behind.
    ~job() {
        if (process_ <= 0 or owner_ != ::getpid()) return;
        ::kill(process_, SIGTERM);
        ::waitpid(process_, nullptr, 0);
        forget_files();
    }
    enum class status { working, done, no_compiler, failed };
    /// Goes on as far as that is possible without waiting, or to the end.
    status look(bool wait) {
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
    [[nodiscard]] functions const& made() const { return made_; }

private:
    void begin() {
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
        if (files::exists(library_)) {
            if (content(source_) == text_)
                load();
            else
                result_ = status::failed; // another text of this hash
            return;
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
    void spawn() {
        std::vector<std::string> words;
        std::istringstream compiler(variable("CC").value_or("cc"));
        for (std::string word; compiler >> word;) words.push_back(word);
        if (words.empty()) words.emplace_back("cc");
        words.insert(words.end(), options.begin(), options.end());
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
    /// The text first: a library with no text beside it is not used.
    void finish() {
        std::error_code failed;
        files::rename(own_source_, source_, failed);
        if (not failed) files::rename(own_library_, library_, failed);
        if (failed)
            result_ = status::failed;
        else
            load();
    }
    void load() {
        result_ = status::failed;
        void* const library = ::dlopen(library_.c_str(), RTLD_NOW | RTLD_LOCAL); // stays: somebody may be in it when the program ends
        if (library == nullptr) return;
        for (std::size_t k = 0; k < made_.size(); ++k) {
            made_[k] = reinterpret_cast<translation::function>(::dlsym(library, ("part_" + std::to_string(k)).c_str()));
            if (made_[k] == nullptr) return;
        }
        result_ = status::done;
    }
    void forget_files() {
        std::error_code never_mind;
        files::remove(own_source_, never_mind);
        files::remove(own_library_, never_mind);
    }
    std::string text_;
    files::path kept_, library_, source_, own_library_, own_source_;
    ::pid_t process_ = 0; ///< -1 when there is none any more
    ::pid_t owner_ = ::getpid();
    status result_ = status::working;
    functions made_{};
};

class compiler final : public hilger::detail::translator<double> {
public:
    void translate(evaluation const& what, translation& to) override {
        auto const how = how_.load();
        if (how == machine_code::off) return;
        std::unique_lock lock(busy_, std::defer_lock);
        if (how == machine_code::at_once)
            lock.lock();
        else if (not lock.try_lock())
            return;
        std::string text = c_of(what);
        if (text.empty()) return;
        auto const [found, is_new] = jobs_.try_emplace(text, nullptr);
        if (is_new) found->second = std::make_unique<job>(std::move(text));
        switch (found->second->look(how == machine_code::at_once)) {
        case job::status::working:
        case job::status::failed:
            return;
        case job::status::no_compiler:
            say_once();
            return;
        case job::status::done:
            to.set(found->second->made());
            ++translated_;
        }
    }
    /// Forgets what it has looked at.
    void set(machine_code how) {
        std::lock_guard const lock(busy_);
        jobs_.clear();
        how_ = how;
    }
    [[nodiscard]] int translated() const { return translated_; }

private:
    void say_once() {
        if (std::exchange(has_said_, true)) return;
        std::cerr << "hilger: there is no C compiler (cc, or what CC names), and formulas go on interpreted; HILGER_MACHINE_CODE=off says "
                     "nothing\n";
    }
    std::atomic<machine_code> how_ = machine_code::off;
    std::atomic<int> translated_ = 0;
    std::mutex busy_;
    std::map<std::string, std::unique_ptr<job>> jobs_;
    bool has_said_ = false;
};

compiler& the_compiler() {
    static compiler one;
    return one;
}

} // namespace

void set_machine_code(machine_code how) {
    auto& one = the_compiler();
    one.set(how);
    hilger::detail::translator<double>::installed() = &one;
}
void prepare_machine_code() {
    static bool const once = [] {
        if (hilger::detail::translator<double>::installed().load() == nullptr)
            set_machine_code(variable("HILGER_MACHINE_CODE") == "off" ? machine_code::off : machine_code::on);
        return true;
    }();
    (void)once;
}
int formulas_in_machine_code() { return the_compiler().translated(); }

} // namespace engine
