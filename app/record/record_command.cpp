#include "app/commands.hpp"

#include "app/output/picture/markup.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/table_files.hpp"
#include "app/output/unique_names.hpp"
#include "app/record/record_pictures.hpp"
#include "app/record/record_table.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "ground/motion_facts.hpp"
#include "ground/pulse.hpp"
#include "ground/record_error.hpp"
#include "ground/stochastic_motion.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace app {
namespace {

constexpr std::string_view kRecordList = "drystone_record_files.txt";

ground::Record formula_record(ground::GroundMotion motion, const std::string& name)
{
    ground::Record r;
    r.motion = std::move(motion);
    r.motion.name = name;
    r.format = "formula";
    r.unit = "-";
    return r;
}

ground::Record pulse_record(const std::string& text)
{
    try {
        return formula_record(ground::pulse(text), text);
    } catch (const std::invalid_argument& bad) {
        throw ConfigError("drystone", 0, "record", bad.what());
    }
}

std::vector<ground::Record> stochastic_records(const std::string& text)
{
    try {
        std::vector<ground::Record> all;
        for (ground::GroundMotion& m : ground::stochastic_motions(text)) {
            const std::string name = m.name;
            all.push_back(formula_record(std::move(m), name));
        }
        return all;
    } catch (const std::invalid_argument& bad) {
        throw ConfigError("drystone", 0, "record", bad.what());
    }
}

std::vector<ground::Record> all_records(const Command& command)
{
    if (!command.unit.empty() && ground::acceleration_unit(command.unit) == 0.0)
        throw ConfigError("drystone", 0, "--acceleration-unit",
                          "is no unit of acceleration; use g, m/s2, cm/s2, mm/s2 or g/10");
    std::vector<ground::Record> all;
    for (const std::string& word : command.words) {
        if (ground::is_stochastic(word)) {
            for (ground::Record& r : stochastic_records(word)) all.push_back(std::move(r));
            continue;
        }
        if (ground::is_pulse(word)) {
            all.push_back(pulse_record(word));
            continue;
        }
        try {
            for (ground::Record& r : ground::read_records(word, {command.unit}))
                all.push_back(std::move(r));
        } catch (const ground::RecordError& bad) {
            throw ConfigError(bad.file(), bad.line(), "", bad.why());
        }
    }
    return all;
}

std::vector<ground::Measure> measures_of(const Command& command)
{
    std::vector<ground::Measure> all = usual_measures();
    for (const std::string& text : command.measures) try {
            const ground::Measure measure = ground::parse_measure(text);
            const auto same = [name = measure_text(measure)](const ground::Measure& m) {
                return measure_text(m) == name;
            };
            if (std::ranges::none_of(all, same)) all.push_back(measure);
        } catch (const std::invalid_argument& bad) {
            throw ConfigError("drystone", 0, "--measure", bad.what());
        }
    return all;
}

std::string history_csv(const ground::GroundMotion& m)
{
    constexpr int kDigits = 9;
    const ground::Trace t = integrated(m);
    std::string text = "time_s,acceleration_g,velocity_m_s,displacement_m\n";
    for (std::size_t i = 0; i < m.acceleration.size(); ++i)
        text += number(m.step * static_cast<double>(i), kDigits) + ',' +
                number(m.acceleration[i] / ground::kGravity, kDigits) + ',' +
                number(t.velocity[i], kDigits) + ',' + number(t.displacement[i], kDigits) +
                '\n';
    return text;
}

std::vector<double> spectrum_of(const ground::GroundMotion& m)
{
    std::vector<double> s;
    for (const double period : spectrum_periods())
        s.push_back(spectral_acceleration(m, period) / ground::kGravity);
    return s;
}

} // namespace

int record_command(const Command& command)
{
    const std::vector<ground::Measure> measures = measures_of(command);
    if (const std::string note =
            check_results(command.out, {"records.csv", "spectra.csv"}, kRecordList);
        !command.quiet)
        std::cerr << note;
    const std::vector<ground::Record> records = all_records(command);
    const Table table = record_table(records, measures);
    std::vector<std::vector<double>> spectra;
    for (const ground::Record& r : records) spectra.push_back(spectrum_of(r.motion));
    std::vector<OutputFile> files;
    UniqueNames names;
    for (const ground::Record& r : records) {
        const std::string stem = "motions/" + names.add(plain_name(r.motion.name, "motion"));
        files.push_back({stem + ".csv", history_csv(r.motion)});
        files.push_back({stem + ".svg", motion_svg(r)});
    }
    files.push_back({"spectra.csv", as_csv(spectrum_table(records, spectra))});
    files.push_back({"spectra.svg", spectrum_svg(records, spectra)});
    add_table(files, "records", table);
    write_results(command.out, files, kRecordList);
    std::cout << as_text(table, terminal_width()) << "written to " << command.out << '\n';
    return 0;
}

} // namespace app
