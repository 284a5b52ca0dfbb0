#pragma once
/// One line that says how far a run is and how long it will take.

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace app {

struct ProgressOptions {
    bool terminal = false;   ///< redraw one line; else plain lines
    bool quiet = false;      ///< write nothing
    int width = 80;          ///< of the terminal in columns, > 0
    bool ends_early = false; ///< the work may turn out less: "at most 0:15 left"
};

/// Silent for the first two seconds. In a terminal: one line, redrawn at most 10 times a
/// second. Elsewhere: a line every 10 s, and one at the end if there was one before. Not
/// thread-safe: callers from several threads lock around update().
class Progress {
  public:
    using Clock = std::function<double()>; ///< [s], never backwards

    /// @param begin share of the work that was done before, in [0, 1]: it took no time
    Progress(std::ostream& out, ProgressOptions options, Clock clock, double begin = 0.0);
    /// Ends a line that was drawn and not finished, so that an error message starts on a line
    /// of its own.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// @param done share of the work in [0, all]; outside, and NaN, is clamped
    /// @param text free text at the end of the line, e.g. "49.7 kN at 9.8 mm"
    /// @param all the whole work in this measure: more than 1 where it has grown on the way
    void update(double done, std::string_view text, double all = 1.0);

    /// Adds a sentence on a line of its own, above the next line that is drawn.
    void remark(std::string_view sentence);

    /// Draws 100 % and the time taken, if anything was drawn before. Later calls do nothing.
    void finish(std::string_view text);

  private:
    void follow_rate(double now, double done);
    void write_line(const std::string& line, double now);
    [[nodiscard]] std::string line(double done, const std::string& time,
                                   std::string_view text) const;

    std::ostream& out_;
    ProgressOptions options_;
    Clock clock_;
    double start_ = 0.0, last_sample_ = 0.0, last_done_ = 0.0; ///< [s], [s], [-]
    double done_sum_ = 0.0, time_sum_ = 0.0; ///< fading sums; their ratio is the rate [1/s]
    double last_drawn_ = 0.0;                ///< [s]
    std::string remarks_;                    ///< lines that are not written yet
    bool drawn_ = false, finished_ = false;
};

/// For std::cerr: whether it is a terminal, and how wide.
[[nodiscard]] ProgressOptions stderr_progress(bool quiet);

/// Seconds of a clock that never goes backwards.
[[nodiscard]] double steady_seconds();

/// 65 -> "1:05", 3700 -> "1:01:40"; "-:--" if not finite or negative.
[[nodiscard]] std::string clock_text(double seconds);

} // namespace app
