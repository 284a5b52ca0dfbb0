#include "app/wall_verbs.hpp"

#include "app/input/command_line.hpp"
#include "app/input/keys_page.hpp"
#include "app/input/study/code_file.hpp"
#include "app/input/study/material_presets.hpp"
#include "app/output/picture/markup.hpp"
#include "app/program_version.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/verbs.hpp"
#include "app/version.hpp"
#include "dem/solver/solver_revision.hpp"

#include <iostream>

namespace app {

int help_command(const Command& command)
{
    const std::string topic = command.words.empty() ? "" : command.words.front();
    std::cout << (topic == "materials" ? materials_page()
                  : topic == "codes"   ? codes_page()
                  : topic == "keys"    ? keys_page()
                  : topic == "numbers" ? numbers_page()
                                       : hung(help_text(verbs(), topic), terminal_width()));
    return 0;
}

int version_command(const Command&)
{
    std::cout << "drystone " << kVersion << '\n';
    if (!commit().empty()) std::cout << "commit " << commit() << '\n';
    std::cout << "solver revision " << dem::kSolverRevision << '\n';
    return 0;
}

} // namespace app
