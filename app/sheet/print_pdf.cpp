#include "app/sheet/print_pdf.hpp"

#include "app/output/run_program.hpp"

#include <string>
#include <system_error>

namespace app {

std::string print_pdf(const std::filesystem::path& html, const std::filesystem::path& pdf)
{
    std::filesystem::path part = pdf;
    part += ".part"; // appears complete or not at all
    const int code = run_program({"weasyprint", html.string(), part.string()});
    std::error_code error;
    if (code == 0) std::filesystem::rename(part, pdf, error);
    if (code == 0 && !error) return pdf.string() + " written";
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    if (is_missing(code))
        return "no PDF: install WeasyPrint (Debian: apt install weasyprint), or print the page "
               "from a browser";
    return "no PDF: WeasyPrint failed; print the page from a browser";
}

} // namespace app
