# Formula for Homebrew on Linux. packaging/release.sh writes the place and the checksum of the tarball into the copy of a release:
#   brew install --build-from-source ./drystone.rb
# It was not run: Homebrew cannot be reached from where it was written.
class Drystone < Formula
  desc "Stochastic discontinuum analysis of dry-joint stone masonry walls"
  url "@URL@/drystone-0.5.0.tar.gz"
  sha256 "@SHA256@"
  license "GPL-3.0-or-later"

  depends_on "cgal" => :build
  depends_on "cmake" => :build
  depends_on "cpp-httplib" => :build
  depends_on "eigen" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "boost"
  depends_on "expat"
  depends_on "gsl"
  depends_on "hdf5"
  depends_on "libpng"
  depends_on :linux
  depends_on "nlopt"
  depends_on "zlib"

  # Headers alone.
  resource "random123" do
    url "https://deb.debian.org/debian/pool/main/libr/librandom123/librandom123_1.14.0+dfsg.orig.tar.xz"
    sha256 "0ed9bf1de7732303f35529ff9b42b0ab84e1fbeaad8ba97768440d8e2b109e87"
  end

  def install
    (buildpath/"random123").install resource("random123")
    package = Hardware::CPU.intel? ? "ON" : "OFF"
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DCMAKE_UNITY_BUILD=ON", "-DDRYSTONE_WERROR=OFF",
           "-DDRYSTONE_BUILD_TESTS=OFF", "-DDRYSTONE_BUILD_BENCH=OFF", "-DDRYSTONE_PYTHON=OFF", "-DDRYSTONE_PACKAGE=#{package}",
           "-DRANDOM123_INCLUDE_DIR=#{buildpath}/random123/include", *std_cmake_args
    system "cmake", "--build", "build"
    if package == "ON"
      system "cmake", "--install", "build", "--component", "program"
    else
      bin.install "build/app/drystone"
    end
    pkgshare.install "configs"
  end

  test do
    system bin/"drystone", "push", pkgshare/"configs/wall.ini", "--out", testpath/"wall"
    assert_match "peak_force_kN", (testpath/"wall/summary.json").read
  end
end
