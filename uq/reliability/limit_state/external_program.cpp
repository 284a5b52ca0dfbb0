#include "uq/reliability/limit_state/external_program.hpp"

#include "uq/reliability/limit_state/external_program_process.hpp"
#include "uq/reliability/limit_state/external_program_result.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <limits>
#include <list>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>

namespace uq {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

void check(const ExternalProgram& p)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("external program: " + what);
    };
    require(!p.command.empty() && !p.command.front().empty(), "there is no command");
    for (const auto* names : {&p.parameters, &p.responses}) {
        const bool empty = std::ranges::any_of(*names, &std::string::empty);
        const std::set<std::string> different(names->begin(), names->end());
        require(!empty && different.size() == names->size(),
                "names must not be empty, and each may occur once");
    }
    require(!p.responses.empty(), "there are no responses");
    require(p.concurrent >= 1, "concurrent must be at least 1");
    require(p.retries >= 0, "retries must be at least 0");
    require(p.stderr_lines >= 0, "stderr_lines must be at least 0");
    require(p.time_limit >= 0.0 && std::isfinite(p.time_limit), "time_limit must be >= 0 s");
    require(p.grace >= 0.0 && std::isfinite(p.grace), "grace must be >= 0 s");
}

/// A directory for the runs of one batch, removed at the end with all that is not kept.
struct RunDirectory {
    fs::path path;
    bool keeps; ///< directories of some runs stay

    RunDirectory(const fs::path& parent, bool keeps_some) : keeps(keeps_some)
    {
        const fs::path base = parent.empty() ? fs::temp_directory_path() : parent;
        fs::create_directories(base);
        std::string name = (fs::absolute(base) / "drystone-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw fs::filesystem_error("no directory for runs", base,
                                       std::error_code(errno, std::generic_category()));
        path = name;
    }
    RunDirectory(const RunDirectory&) = delete;
    RunDirectory& operator=(const RunDirectory&) = delete;
    ~RunDirectory()
    {
        std::error_code ignored;
        if (!keeps)
            fs::remove_all(path, ignored);
        else
            fs::remove(path, ignored); // only if empty
    }
};

struct Try {
    std::size_t row;
    int number; ///< 1 for the first
};

/// A run under way.
struct ProgramRun {
    Try of;
    fs::path directory;
    Process process;
    Clock::time_point deadline;
    enum class State { running, asked_to_stop, killed } state = State::running;
};

std::string filled_in(std::string text,
                      const std::vector<std::pair<std::string, std::string>>& by)
{
    for (const auto& [key, value] : by)
        for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos;
             at += value.size())
            text.replace(at, key.size(), value);
    return text;
}

bool prints_result(const ExternalProgram& p)
{
    return std::ranges::none_of(p.command, [](const std::string& word) {
        return word.find("{output}") != std::string::npos;
    });
}

Launch launch(const ExternalProgram& p, const fs::path& directory, std::uint64_t sample, Try t)
{
    const std::string here = fs::current_path().string();
    Launch l{{},
             directory,
             directory / "input.json",
             directory / "stdout",
             directory / "stderr",
             p.environment};
    for (const std::string& word : p.command)
        l.command.push_back(filled_in(word, {{"{input}", (directory / "input.json").string()},
                                             {"{output}", (directory / "output.json").string()},
                                             {"{directory}", directory.string()},
                                             {"{sample}", std::to_string(sample)},
                                             {"{here}", here}}));
    // A program named by a path is found from where the analysis runs.
    if (l.command.front().find('/') != std::string::npos)
        l.command.front() = fs::absolute(l.command.front()).string();
    l.environment.emplace_back("DRYSTONE_SAMPLE", std::to_string(sample));
    l.environment.emplace_back("DRYSTONE_TRY", std::to_string(t.number));
    return l;
}

/// The runs of one batch of samples.
class Batch {
  public:
    Batch(const ExternalProgram& program, const Samples& samples)
        : p_(program), s_(samples), where_(program.directory, program.keep != Keep::none),
          answer_{Eigen::MatrixXd::Constant(samples.x.rows(),
                                            static_cast<Eigen::Index>(program.responses.size()),
                                            std::numeric_limits<double>::quiet_NaN()),
                  std::vector<std::string>(samples.id.size())}
    {
    }

    Responses run()
    {
        for (std::size_t row = 0; row < s_.id.size(); ++row) waiting_.push_back({row, 1});
        Seconds nap = kShortestNap;
        while (!waiting_.empty() || !running_.empty()) {
            while (!waiting_.empty() && std::cmp_less(running_.size(), p_.concurrent)) {
                const Try t = waiting_.front();
                waiting_.pop_front();
                start(t);
            }
            if (look()) {
                nap = kShortestNap;
            } else {
                std::this_thread::sleep_for(nap);
                nap = std::min(kLongestNap, nap * 1.2);
            }
            if (p_.while_waiting) p_.while_waiting();
        }
        return std::move(answer_);
    }

  private:
    static constexpr Seconds kShortestNap{2e-4}, kLongestNap{1e-2};
    static constexpr double kForever = 1e9; ///< [s]; the clock cannot hold much more

    void start(Try t)
    {
        const std::uint64_t sample = s_.id[t.row];
        const Eigen::VectorXd x = s_.x.row(static_cast<Eigen::Index>(t.row));
        if (!x.allFinite()) return fail(t.row, "a parameter is not finite: not run");
        const fs::path directory =
            where_.path / ("row-" + std::to_string(t.row) + "-sample-" +
                           std::to_string(sample) + "-try-" + std::to_string(t.number));
        fs::create_directory(directory);
        std::ofstream(directory / "input.json") << input_text(sample, p_.parameters, x);
        try {
            running_.push_back(
                {t, directory, Process(launch(p_, directory, sample, t)), Clock::now()});
        } catch (const std::runtime_error& e) {
            return conclude(t, directory, {{}, e.what(), false});
        }
        running_.back().deadline += std::chrono::duration_cast<Clock::duration>(
            Seconds(p_.time_limit > 0.0 ? std::min(p_.time_limit, kForever) : kForever));
    }

    /// Whether a run has ended.
    bool look()
    {
        bool any = false;
        for (auto run = running_.begin(); run != running_.end();) {
            if (!run->process.ended()) {
                enforce_limit(*run++);
                continue;
            }
            any = true;
            conclude(run->of, run->directory, result(*run));
            run = running_.erase(run);
        }
        return any;
    }

    void enforce_limit(ProgramRun& run) const
    {
        if (run.state == ProgramRun::State::killed || Clock::now() < run.deadline) return;
        const bool again = run.state == ProgramRun::State::asked_to_stop;
        run.process.signal_group(again ? SIGKILL : SIGTERM);
        run.state = again ? ProgramRun::State::killed : ProgramRun::State::asked_to_stop;
        run.deadline += std::chrono::duration_cast<Clock::duration>(Seconds(p_.grace));
    }

    ProgramResult result(const ProgramRun& run) const
    {
        ProgramResult r;
        if (run.state != ProgramRun::State::running) {
            std::string limit = std::to_string(p_.time_limit);
            limit.erase(limit.find_last_not_of('0') + 1);
            r.failure = "no answer within " + limit + (limit.back() == '.' ? "0 s" : " s") +
                        (run.state == ProgramRun::State::killed ? ", killed" : ", stopped");
        } else {
            r.failure = run.process.failure();
        }
        if (r.failure.empty())
            r = read_result(run.directory / (prints_result(p_) ? "stdout" : "output.json"),
                            p_.responses);
        if (!r.failure.empty() && !r.declared) {
            const std::string errors = last_lines(run.directory / "stderr", p_.stderr_lines);
            if (!errors.empty()) r.failure += "; stderr: " + errors;
        }
        return r;
    }

    void conclude(Try t, const fs::path& directory, const ProgramResult& r)
    {
        const bool good = r.failure.empty();
        const bool keep = p_.keep == Keep::all || (p_.keep == Keep::failed && !good);
        std::error_code ignored;
        if (!keep) fs::remove_all(directory, ignored);
        if (good)
            answer_.y.row(static_cast<Eigen::Index>(t.row)) = r.y.transpose();
        else if (!r.declared && t.number <= p_.retries)
            waiting_.push_back({t.row, t.number + 1});
        else
            fail(t.row, (t.number > 1 ? "try " + std::to_string(t.number) + ": " : "") +
                            r.failure + (keep ? "; kept in " + directory.string() : ""));
    }

    void fail(std::size_t row, std::string why) { answer_.failure[row] = std::move(why); }

    const ExternalProgram& p_;
    const Samples& s_;
    RunDirectory where_;
    Responses answer_;
    std::deque<Try> waiting_;
    std::list<ProgramRun> running_;
};

} // namespace

BlackBox external_model(ExternalProgram program)
{
    check(program);
    return [program = std::move(program)](const Samples& s) {
        if (!std::cmp_equal(program.parameters.size(), s.x.cols()))
            throw std::invalid_argument(
                "external program: samples have " + std::to_string(s.x.cols()) +
                " columns for " + std::to_string(program.parameters.size()) + " parameters");
        return Batch(program, s).run();
    };
}

} // namespace uq
