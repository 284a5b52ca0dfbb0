#include "app/study/interrupt.hpp"

#include <csignal>
#include <cstdlib>
#include <initializer_list>

namespace app {
namespace {

volatile std::sig_atomic_t noted = 0;

void note(int signal)
{
    if (noted != 0 && signal == SIGINT) std::_Exit(130);
    noted = 1;
}

} // namespace

void catch_interrupts()
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) std::signal(signal, note);
}

bool interrupted() { return noted != 0; }

} // namespace app
