#include "app/shake/shake_files.hpp"

#include "app/output/energy_json.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/program_version.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "app/version.hpp"
#include "dem/solver/solver_revision.hpp"
#include "fragility/curve/drift.hpp"
#include "ground/motion_facts.hpp"
#include "ground/record.hpp"

namespace app {
namespace {

std::string shaken_history_csv(const dem::ShakeResult& r)
{
    constexpr int kDigits = 9;
    std::string text =
        "time_s,ground_acceleration_g,displacement_mm,drift_percent,base_shear_kN\n";
    for (const dem::HistoryPoint& p : r.history)
        text += number(p.time, kDigits) + ',' + number(p.ground / ground::kGravity, kDigits) +
                ',' + number(p.displacement * 1e3, kDigits) + ',' +
                number(fragility::percent_drift(p.displacement, r.top_height), kDigits) + ',' +
                number(p.base_shear * 1e-3, kDigits) + '\n';
    return text;
}

std::string shaken_history_svg(const ShakenWall& w)
{
    Chart c;
    c.title = w.motion.name;
    c.x_label = "time [s]";
    c.y_label = "drift [%]";
    Series s;
    s.colour = palette(0);
    for (const dem::HistoryPoint& p : w.result.history) {
        s.x.push_back(p.time);
        s.y.push_back(fragility::percent_drift(p.displacement, w.result.top_height));
    }
    c.series.push_back(s);
    return line_chart(c);
}

} // namespace

std::string shaken_summary(const ShakenWall& w, const std::string& study)
{
    const dem::ShakeResult& r = w.result;
    const bool failed = shake_failed(r), fell = r.outcome == dem::ShakeOutcome::collapsed;
    const auto drift = [&](double x) {
        return failed ? Json(nullptr) : or_null(fragility::percent_drift(x, r.top_height));
    };
    Json j;
    j["motion"] = w.motion.name;
    j["outcome"] = dem::name_of(r.outcome);
    j["peak_ground_acceleration_g"] = or_null(peak_ground_g(w));
    j["vertical_stress_MPa"] = or_null(w.vertical_stress * 1e-6);
    j["load_mass"] = w.load == dem::LoadMass::floor ? "floor" : "none";
    j["max_drift_percent"] = drift(r.most_displacement);
    j["residual_drift_percent"] = fell ? Json(nullptr) : drift(r.residual_displacement);
    j["overturned"] = r.overturned;
    j["collapse_time_s"] = fell ? or_null(r.collapse_time) : Json(nullptr);
    j["drift_height_m"] = or_null(r.top_height);
    j["energy_residual"] = or_null(r.residual);
    j["energy"] = energy_json(r.energy);
    j["step_s"] = or_null(r.time_step);
    j["step_reductions"] = r.step_reductions;
    j["steps"] = r.steps;
    j["trust"] = "verified against closed forms, not validated: no open test of a dry-joint "
                 "wall that is shaken in its plane is known";
    j["version"] = kVersion;
    j["commit"] = commit().empty() ? Json(nullptr) : Json(commit());
    j["solver_revision"] = dem::kSolverRevision;
    j["study"] = study;
    return text_of(j, 2) + "\n";
}

bool shake_failed(const dem::ShakeResult& r)
{
    return r.outcome != dem::ShakeOutcome::stood && r.outcome != dem::ShakeOutcome::collapsed;
}

double peak_ground_g(const ShakenWall& w)
{
    return ground::motion_facts(w.motion.horizontal).pga / ground::kGravity;
}

std::vector<OutputFile> shake_files(const ShakenWall& w, const std::string& study,
                                    const std::string& wall_picture, const std::string& film)
{
    std::vector<OutputFile> files = {{"study.ini", study},
                                     {"summary.json", shaken_summary(w, study)}};
    if (shake_failed(w.result)) return files;
    files.push_back({"history.csv", shaken_history_csv(w.result)});
    files.push_back({"history.svg", shaken_history_svg(w)});
    files.push_back({"wall.svg", wall_picture});
    if (!film.empty()) files.push_back({"film.svg", film});
    return files;
}

} // namespace app
