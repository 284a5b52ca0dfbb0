#include "app/input/sheet_offer.hpp"

#include "app/input/study_name.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

namespace app {
std::string sheet_offer(const std::filesystem::path& read, const std::string& title,
                        std::span<const double> stresses)
{
    std::string text = "one page to print: drystone sheet " + in_shell(read.string());
    if (!is_study_name(read.string()))
        text += " --out " + in_shell((read.parent_path() / "sheet.html").string());
    if (stresses.size() > 1) text += " --level " + number(stresses.front() / 1e6, 12);
    if (!title.empty()) text += " --title " + in_shell(title);
    return text;
}

} // namespace app
