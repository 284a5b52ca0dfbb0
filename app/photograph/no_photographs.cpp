// In place of the files that need OpenCV and libjpeg-turbo, where these were not found.
#include "app/photograph/photograph.hpp"

namespace app {
namespace {

[[noreturn]] void refuse_photograph(const DrawingFrame& frame)
{
    refuse(frame, 0,
           "is a photograph, and this program was built without the libraries that read it; "
           "install libopencv-core-dev, libopencv-imgproc-dev and libturbojpeg0-dev (Debian), "
           "and run ./drystone again, which then builds it anew; or paint the stones");
}

} // namespace

Picture read_jpeg(const DrawingFrame& frame, std::string_view /*bytes*/)
{
    refuse_photograph(frame);
}

FoundStones find_photographed(const DrawingFrame& frame, const Picture& /*picture*/,
                              StoneMethod /*method*/)
{
    refuse_photograph(frame);
}

} // namespace app
