// Tests that refused flags and job files cause one line that names the flag, and exit code 2.
#include <gmock/gmock.h>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

struct Refusal {
  Words arguments;
  std::string part_of_message;
};

class Refusals : public testing::TestWithParam<Refusal> {};

TEST_P(Refusals, are_one_line_with_the_flag) {
  const TempDir dir;
  expect_refusal(run_tool(dir, GetParam().arguments), 2, GetParam().part_of_message);
  EXPECT_TRUE(std::filesystem::is_empty(dir.path()));
}

Refusal render(const Words& flags, const std::string& part_of_message) {
  return {Words{"render", "teapot", "--frames", "0"} + flags, part_of_message};
}

INSTANTIATE_TEST_SUITE_P(
    Layouts, Refusals,
    testing::Values(render({"--quilt", "4x2"}, "--layout quilt"),
                    render({"--pseudoscopic", "--layout", "quilt"}, "--layout integral"),
                    render({"--to", "hcl"}, "did you mean 'hci'?"),
                    render({"--to", "hci", "--layout", "quilt"}, "--to: hci cannot be combined with --layout"),
                    render({"--to", "hci", "--optics", "multiview", "--aov", "normal"}, "--aov: files of the format hci"),
                    render({"--size", "20000x20000"}, "--format tiff"), render({"-o", "-"}, "--output")));

INSTANTIATE_TEST_SUITE_P(
    Light, Refusals,
    testing::Values(render({"--transparent", "--video", "a.mp4"}, "--transparent: cannot be combined with --video"),
                    render({"--integrator", "path", "--reuse", "forward"}, "--reuse: interpolate needs Whitted shading"),
                    render({"--integrator", "path", "--reuse", "forward"}, "or --integrator whitted"),
                    render({"--denoise"}, "--denoise: has no effect"), render({"--splat", "lens"}, "--splat"),
                    render({"--denoise", "auto"}, "--denoise: has no effect"),
                    render({"--integrator", "path", "--min-psnr", "40"},
                           "--reuse interpolate; for path tracing, --spp in place of --min-psnr"),
                    render({"--reuse", "backward"}, "--reuse"), render({"--min-psnr", "5", "--reuse", "none"}, "--min-psnr"),
                    render({"--fit-depth", "--full-depth"}, "--full-depth")));

INSTANTIATE_TEST_SUITE_P(
    Displays, Refusals,
    testing::Values(render({"--display", "portait"}, "did you mean 'portrait'?"),
                    render({"--display", "portrait", "--lenses", "20"}, "--lenses"),
                    render({"--layout", "native"}, "--display"), render({"--crosstalk", "0.3"}, "--precompensate"),
                    Refusal{{"render", "test-pattern", "--aov", "depth"}, "no extra layers"},
                    Refusal{{"convert", "out", "x", "--crosstalk", "0.3"}, "--precompensate"},
                    Refusal{{"convert", "a.png", "b.png", "--from", "native", "--to", "views"}, "--display"}));

INSTANTIATE_TEST_SUITE_P(
    Conversions, Refusals,
    testing::Values(render({"--ipd", "60"}, "--layout stereo"), render({"--right-first"}, "--right-first"),
                    Refusal{{"convert", "a.png", "b", "--from", "quilt", "--to", "views", "--ipd", "60"}, "--to stereo"},
                    Refusal{{"convert", "x.png", "v", "--from", "quilt", "--to", "views", "--near-black"}, "--from rgbd"},
                    Refusal{{"convert", "out", "a", "--rotate-elemental", "--spoc", "8"}, "--spoc"}));

INSTANTIATE_TEST_SUITE_P(
    Parts, Refusals,
    testing::Values(render({"--only-frames", "7-9"},
                           "--only-frames: 7-9 selects no frame of this render; accepted: frames among 0"),
                    render({"--only-frames", "x"}, "--only-frames: 'x'"),
                    render({"--video", "a.mp4", "--format", "exr", "--unit", "1/2"}, "--video: needs 8-bit pictures"),
                    render({"--unit", "3/2"}, "--unit: '3/2' is not a unit"), render({"--page", "--mirror"}, "--page")));

INSTANTIATE_TEST_SUITE_P(
    FlagsWithoutEffect, Refusals,
    testing::Values(render({"--stereo", "sbs"},
                           "--stereo: has no effect on pictures other than stereo; accepted: --layout stereo"),
                    render({"--right-first"}, "--right-first: has no effect"), render({"--splat", "view"}, "--splat"),
                    render({"--fill", "interpolate"}, "--fill"), render({"--halving"}, "--halving"),
                    render({"--no-z-buffer"}, "--no-z-buffer"), render({"--reuse", "none", "--keyframes", "8"}, "--keyframes"),
                    render({"--integrator", "path", "--spp", "64", "--keyframes", "8"}, "--keyframes: has no effect"),
                    render({"--clamp-indirect", "4"}, "--clamp-indirect: has no effect"),
                    render({"--video-codec", "hevc"}, "--video-codec: has no effect"), render({"--crf", "20"}, "--crf"),
                    render({"--crf", "20", "--video", "a.mkv"}, "--crf: has no effect"),
                    render({"--exr-pixels", "float"}, "--exr-pixels: has no effect"),
                    render({"--format", "exr", "--exposure", "1"}, "--exposure: has no effect"),
                    render({"--format", "exr", "--tone", "agx"}, "--tone: has no effect"),
                    render({"--environment", "none", "--environment-strength", "2"}, "--environment-strength"),
                    render({"--environment", "none", "--environment-rotation", "9"}, "--environment-rotation"),
                    render({"--texture-memory", "100"}, "--texture-memory"), render({"--asset-root", "."}, "--asset-root"),
                    render({"--up", "z"}, "--up: has no effect"), render({"--points", "1"}, "--points: has no effect"),
                    render({"--packing", "square"}, "--packing: has no effect"),
                    render({"--optics", "single", "--full-depth"}, "--fit-depth or --full-depth: has no effect"),
                    render({"--optics", "single", "--view-angle", "20"}, "--view-angle: has no effect"),
                    render({"--environment", "#ff0000", "--environment-rotation", "9"}, "--environment-rotation")));

INSTANTIATE_TEST_SUITE_P(
    Words, Refusals,
    testing::Values(
        render({"--optics", "lentcular"}, "did you mean 'lenticular'?"), render({"--display", "60lpi"}, "did you mean '"),
        render({"--environment", "studo"}, "there is no 'studo', did you mean 'studio'?"),
        render({"--format", "pgn"}, "did you mean 'png'?"),
        render({"--also", "singel"}, "did you mean 'single'?; accepted: single"),
        render({"--progress", "jsn"}, "did you mean 'json'?; accepted: json"),
        render({"--keyframes", "atuo"}, "accepted: auto, or a whole number from 2"),
        render({"--lens-arrangement", "hexagonal"}, "did you mean '--packing'?"),
        render({"--lense", "3"}, "did you mean '--lenses'?"), render({"--reuse", "exactly"}, "--reuse"),
        render({"--spp", "1", "--spp", "2"}, "--spp"), render({"--spp"}, "--spp"), render({"--spp", "-1"}, "from 0 to 65536"),
        render({"--optics", "fresnel"}, "lenticular, microlens, multiview, single"), render({"--size", "0x0"}, "--size"),
        render({"--lens-pixels", "0"}, "--lens-pixels"), render({"--size", "40000x25000"}, "accepted: up to 268435456 pixels"),
        render({"-q", "--verbose"}, "--quiet"), render({"-q", "--progress", "json"}, "--quiet"),
        render({"--verbose", "--progress", "json"}, "--verbose"), Refusal{{"bench", "rays", "--json"}, "lippmann-bench NAME"},
        Refusal{{"help", "bench"}, "lippmann-bench NAME"}, Refusal{{"rendre"}, "did you mean 'render'?"},
        Refusal{{"help", "rendre"}, "did you mean 'render'?"},
        Refusal{{"render", "teapot", "--frames", "470-500"}, "frames from 0 to 479"}));

}  // namespace
}  // namespace lippmann::test
