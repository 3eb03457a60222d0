// SPDX-License-Identifier: BSL-1.0
// A progress bar on a terminal; silence elsewhere.
#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

namespace program {

class progress_bar {
public:
    progress_bar(std::string label, long total) : label_(std::move(label)), total_(total), shown_(isatty(STDERR_FILENO) != 0) {}
    ~progress_bar() {
        if (shown_) std::fprintf(stderr, "\r\033[K");
    }
    progress_bar(progress_bar const&) = delete;
    progress_bar& operator=(progress_bar const&) = delete;

    void advance() { advance_to(done_ + 1); }
    void advance_to(long done) {
        done_ = done;
        int const percent = static_cast<int>(100 * done_ / total_);
        if (not shown_ or percent == percent_) return;
        percent_ = percent;
        std::string const bar(static_cast<std::size_t>(percent / 4), '#');
        std::fprintf(stderr, "\r%-32s [%-25s] %3d %%", label_.c_str(), bar.c_str(), percent);
    }

private:
    std::string label_;
    long total_, done_ = 0;
    int percent_ = -1;
    bool shown_;
};

} // namespace program
