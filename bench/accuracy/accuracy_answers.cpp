#include "bench/accuracy/accuracy_answers.hpp"

#include "app/text/check_sum.hpp"
#include "app/text/csv.hpp"
#include "app/text/number_text.hpp"
#include "app/text/text_file.hpp"
#include "dem/solver/solver_revision.hpp"

#include <fstream>
#include <stdexcept>
#include <utility>

namespace bench {

namespace {

constexpr const char* kHead = "scene,number,revision,settings,outcome,peak [N],at [m],drop [m],"
                              "reported error [-],residual [-],steps,seconds,"
                              "earliest drop [m],latest drop [m]\n";
constexpr std::size_t kMostBytes = 64U << 20U;

std::string key_of(const std::string& scene, const std::string& revision,
                   const std::string& settings, bool any)
{
    return any ? scene : scene + "|" + revision + "|" + settings;
}

std::string cell(const std::optional<double>& x) { return x ? app::number(*x, 17) : ""; }

std::optional<double> read(const std::string& cell)
{
    if (cell.empty()) return {};
    return std::stod(cell);
}

Answer answer_of(const std::vector<std::string>& cells)
{
    Answer a;
    a.outcome = cells[4];
    a.peak = read(cells[5]);
    a.peak_at = read(cells[6]);
    a.drop = read(cells[7]);
    a.solver_error = read(cells[8]).value_or(0.0);
    a.residual = read(cells[9]).value_or(0.0);
    a.steps = std::stoll(cells[10]);
    a.seconds = std::stod(cells[11]);
    a.earliest = read(cells[12]);
    a.latest = read(cells[13]);
    return a;
}

} // namespace

AnswerFile::AnswerFile(std::filesystem::path file, bool any) : file_(std::move(file)), any_(any)
{
    if (file_.empty() || !std::filesystem::exists(file_)) return;
    const std::string text = app::read_bytes(file_.string(), kMostBytes, "is too large", "");
    if (!text.starts_with(kHead))
        throw std::runtime_error(file_.string() + " is no file of answers");
    for (const app::CsvRow& row : app::parse_csv(file_.string(), text).rows) {
        answers_[key_of(row.cells[0], row.cells[2], row.cells[3], any_)] = answer_of(row.cells);
        revision_ = row.cells[2];
    }
}

std::optional<Answer> AnswerFile::find(const std::string& text, const std::string& settings,
                                       double most_seconds) const
{
    const std::lock_guard lock(mutex_);
    const auto found = answers_.find(
        key_of(app::check_sum(text), std::to_string(dem::kSolverRevision), settings, any_));
    if (found == answers_.end()) return {};
    const Answer& a = found->second;
    if (!any_ && a.outcome == kTooDear && a.seconds < 0.95 * most_seconds) return {};
    return a;
}

void AnswerFile::add(std::uint64_t number, const std::string& text, const std::string& settings,
                     const Answer& a)
{
    if (file_.empty()) return;
    const std::string scene = app::check_sum(text),
                      revision = std::to_string(dem::kSolverRevision);
    const std::lock_guard lock(mutex_);
    answers_[key_of(scene, revision, settings, any_)] = a;
    const bool fresh = !std::filesystem::exists(file_);
    std::ofstream out(file_, std::ios::app);
    if (fresh) out << kHead;
    out << scene << ',' << number << ',' << revision << ',' << settings << ',' << a.outcome
        << ',' << cell(a.peak) << ',' << cell(a.peak_at) << ',' << cell(a.drop) << ','
        << cell(a.solver_error) << ',' << cell(a.residual) << ',' << a.steps << ','
        << app::fixed(a.seconds, 3) << ',' << cell(a.earliest) << ',' << cell(a.latest) << '\n';
    if (!out.flush()) throw std::runtime_error("cannot write " + file_.string());
}

} // namespace bench
