#include "bench/report.hpp"

#include "app/output/atomic_output.hpp"
#include "bench/machine.hpp"

namespace bench {

std::string as_markdown(const Report& r)
{
    std::string text = "# " + r.title + "\n\nWritten by `" + command_line() + "` on " +
                       machine_line() + "; caches " + cache_line() + ".\n";
    if (!r.opening.empty()) text += "\n" + r.opening + "\n";
    for (const Section& s : r.sections) {
        if (!s.title.empty()) text += "\n## " + s.title + "\n";
        if (!s.text.empty()) text += "\n" + s.text + "\n";
        text += "\n" + app::as_markdown(s.table);
    }
    return text;
}

void write_report(const std::filesystem::path& path, const Report& r)
{
    if (path.has_parent_path()) app::make_folder(path.parent_path());
    for (const Section& s : r.sections) {
        std::filesystem::path csv = path;
        csv.replace_filename(path.stem().string() + (s.name.empty() ? "" : "-" + s.name) +
                             ".csv");
        app::write_file(csv, app::as_csv(s.table));
    }
    app::write_file(path, as_markdown(r));
}

} // namespace bench
