#pragma once
/// Random123 refuses processors that it was not tried on. Its integers are those of C++ on any.

#define __riscv 1
#define R123_USE_GNU_UINT128 1
#include_next <Random123/philox.h>
#undef __riscv
