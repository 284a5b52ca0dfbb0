#pragma once
/// A page has no terminal whose width could be asked.

#include_next <sys/ioctl.h>

struct winsize {
    unsigned short ws_col;
};
#define TIOCGWINSZ 0
