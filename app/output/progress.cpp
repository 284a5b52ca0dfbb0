#include "app/output/progress.hpp"

#include "app/text/number_text.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <ostream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace app {

namespace {

constexpr double kSilence = 2.0;     // [s] a run shorter than this says nothing
constexpr double kRedraw = 0.1;      // [s] in a terminal
constexpr double kPlainEvery = 10.0; // [s] elsewhere
constexpr double kRateMemory =
    15.0; // [s] tuned: steady while a wall cracks, quick when its pace changes
constexpr int kBarWidth = 24;

std::string two_digits(long long n) { return (n < 10 ? "0" : "") + std::to_string(n); }

std::string bar(double done)
{
    const int filled = static_cast<int>(std::floor(done * kBarWidth));
    std::string text(static_cast<std::size_t>(filled), '=');
    if (filled < kBarWidth) text += '>';
    text.resize(kBarWidth, ' ');
    return '[' + text + ']';
}

/// Cuts to `columns`, never within a UTF-8 character; counts every character as one column.
std::string cut(const std::string& text, int columns)
{
    int seen = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool starts = (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80;
        if (starts && seen++ == columns) return text.substr(0, i);
    }
    return text;
}

} // namespace

Progress::Progress(std::ostream& out, ProgressOptions options, Clock clock, double begin)
    : out_(out), options_(options), clock_(std::move(clock)), start_(clock_()),
      last_sample_(start_), last_done_(begin), last_drawn_(start_)
{
}

Progress::~Progress()
{
    if (drawn_ && !finished_ && options_.terminal) out_ << '\n' << std::flush;
}

void Progress::update(double done, std::string_view text, double all)
{
    if (options_.quiet || finished_) return;
    const double now = clock_();
    done = done > 0.0 ? std::min(done, all) : 0.0; // NaN: 0
    if (now - last_sample_ >= kRedraw) follow_rate(now, done);

    const double since = now - last_drawn_;
    const bool due =
        options_.terminal ? now - start_ >= kSilence && since >= kRedraw : since >= kPlainEvery;
    if (!due) return;
    const double left = done_sum_ > 0.0 ? (all - done) * time_sum_ / done_sum_
                                        : std::numeric_limits<double>::infinity();
    const std::string time = (options_.ends_early ? "at most " : "") + clock_text(left);
    write_line(line(done / all, time + " left", text), now);
}

void Progress::remark(std::string_view sentence)
{
    if (!finished_) remarks_ += std::string(sentence) + '\n';
}

void Progress::finish(std::string_view text)
{
    if (options_.quiet || finished_) return;
    const double now = clock_();
    if (drawn_) write_line(line(1.0, clock_text(now - start_) + " taken", text), now);
    if (drawn_ && options_.terminal) out_ << '\n' << std::flush;
    finished_ = true;
}

/// Work and time fade alike, so their ratio is a mean over the last kRateMemory seconds, from
/// the first sample on.
void Progress::follow_rate(double now, double done)
{
    const double dt = now - last_sample_;
    const double keep = std::exp(-dt / kRateMemory);
    done_sum_ = keep * done_sum_ + std::max(0.0, done - last_done_);
    time_sum_ = keep * time_sum_ + dt;
    last_sample_ = now;
    last_done_ = done;
}

void Progress::write_line(const std::string& line, double now)
{
    if (!remarks_.empty()) out_ << (options_.terminal ? "\r\033[K" : "") << remarks_;
    remarks_.clear();
    if (options_.terminal)
        out_ << '\r' << cut(line, options_.width - 1) << "\033[K"
             << std::flush; // K: clear the rest
    else
        out_ << line << '\n' << std::flush;
    last_drawn_ = now;
    drawn_ = true;
}

std::string Progress::line(double done, const std::string& time, std::string_view text) const
{
    // 100 % only when it is: 0.999 is 99 %
    std::string percent = fixed(std::floor(done * 100.0), 0);
    percent.insert(0, 3 - std::min<std::size_t>(3, percent.size()), ' ');
    std::string result = percent + " % ";
    if (options_.terminal) result += bar(done) + ' ';
    result += time;
    if (!text.empty()) result += "  " + std::string(text);
    return result;
}

ProgressOptions stderr_progress(bool quiet)
{
    ProgressOptions options{.terminal = ::isatty(STDERR_FILENO) == 1, .quiet = quiet};
    winsize size{};
    if (options.terminal && ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        options.width = size.ws_col;
    return options;
}

double steady_seconds()
{
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

std::string clock_text(double seconds)
{
    if (!(seconds >= 0.0 && seconds < 1e9)) return "-:--";
    const long long s = std::llround(seconds);
    const std::string tail = ':' + two_digits(s % 60);
    if (s < 3600) return std::to_string(s / 60) + tail;
    return std::to_string(s / 3600) + ':' + two_digits(s / 60 % 60) + tail;
}

} // namespace app
