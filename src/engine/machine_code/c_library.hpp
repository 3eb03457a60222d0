// SPDX-License-Identifier: BSL-1.0
// C that becomes part of the running process: a text, a file, a run of the system's compiler and a loaded library, in this order; no stage
// blocks, and look() advances it. Libraries are cached in the user's folder under the hash of their text. The text is stored beside each
// and compared: a hash is no proof. The 256 libraries last used are kept.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace engine {

/// A variable of the environment; nothing when it is unset or empty.
std::optional<std::string> environment_variable(char const* name);

/// One text and its library. Products are not contracted, on any processor.
class c_library {
public:
    /// Other options make another library of the same text.
    explicit c_library(std::string text, std::vector<std::string> options = {});
    c_library(c_library const&) = delete;
    c_library& operator=(c_library const&) = delete;
    /// Ends a compiler that is still running, and removes its files.
    ~c_library();

    enum class status { working, done, no_compiler, failed };
    /// Advances as far as possible without waiting, or with `wait` to the end.
    status look(bool wait);
    /// The address of a function of a loaded library; nullptr when there is none.
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
    ::pid_t process_ = 0; ///< -1 without a process
    ::pid_t owner_;
    status result_ = status::working;
    void* loaded_ = nullptr;
};

} // namespace engine
