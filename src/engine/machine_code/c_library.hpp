// SPDX-License-Identifier: BSL-1.0
// C that becomes part of the running process: text, a file, a process of the system's compiler and a library that is loaded, in this order;
// each step waits for nothing but is looked at again when somebody asks. What is compiled is kept under the name of its text's hash in the
// user's folder for such things, with the text beside it, which is compared: a hash is no proof. 256 libraries stay there, those last used.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace engine {

/// A variable of the environment, where it is set and not empty.
std::optional<std::string> environment_variable(char const* name);

/// One text and what becomes of it. Products are not contracted, whatever the processor.
class c_library {
public:
    /// Other options make another library of the same text.
    explicit c_library(std::string text, std::vector<std::string> options = {});
    c_library(c_library const&) = delete;
    c_library& operator=(c_library const&) = delete;
    /// A compiler that nobody waits for any more ends, and leaves nothing behind.
    ~c_library();

    enum class status { working, done, no_compiler, failed };
    /// Goes on as far as that is possible without waiting, or to the end.
    status look(bool wait);
    /// What is called so, when it is done; nullptr where there is no such thing.
    [[nodiscard]] void* find(std::string const& name) const;

private:
    void begin();
    void spawn();
    void finish();
    bool load();
    void forget_files();
    std::string text_;
    std::vector<std::string> options_;
    std::filesystem::path kept_, library_, source_, own_library_, own_source_;
    ::pid_t process_ = 0; ///< -1 when there is none any more
    ::pid_t owner_;
    status result_ = status::working;
    void* loaded_ = nullptr;
};

} // namespace engine
