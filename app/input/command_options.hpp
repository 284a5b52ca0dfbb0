#pragma once
/// Options of the command line, as they are listed in the help.

#include <boost/program_options/options_description.hpp>

namespace app {

[[nodiscard]] int default_threads(); ///< all of this machine, >= 1

[[nodiscard]] boost::program_options::options_description command_options();

} // namespace app
