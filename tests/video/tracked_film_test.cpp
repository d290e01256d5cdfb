// Reads films that an independent renderer draws, without FFmpeg and OpenCV: outlines come from the renderer's
// geometry.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "coilwright/text/input_error.hpp"
#include "coilwright/video/finger_motion.hpp"
#include "video/film_renderer.hpp"

namespace coilwright::video {
namespace {

constexpr double degree = M_PI / 180.0;

film::Scene small_scene() {
  return {.width = 280, .height = 420, .middle = {8.0, 18.0}, .rate = 240.0, .duration = 0.1, .segment_tag = false};
}

// Turns by `rate` rad/s after `start`.
film::Motion turning(double first, double rate) {
  return {.times = {0.0, 1.0}, .angles = {{0.5 * first, 0.5 * first}, {0.5 * (first + rate), 0.5 * (first + rate)}}};
}

// A film in memory, and the outlines that a search would give, each corner off by up to a pixel.
class Drawn : public Vision {
 public:
  Drawn(const film::Scene& scene, const film::Motion& motion) : scene_(scene), motion_(motion) {}
  std::unique_ptr<PictureSource> open(const std::filesystem::path&) const override {
    return std::make_unique<Source>(scene_, motion_, copies, unstamped);
  }
  std::vector<TagCorners> find_tags(const Picture& picture, const Area&) const override {
    const auto [first, second] = motion_.at(picture.time);
    const double angle = first + second;
    std::vector<TagCorners> out{outline(0, 0.0, -12.0, 0.0),
                                outline(1, 30.0 * std::sin(first) + 18.0 * std::sin(angle),
                                        30.0 * std::cos(first) + 18.0 * std::cos(angle), angle)};
    if (twins) out.push_back(out.back());
    if (baseless) out.erase(out.begin());
    return blind ? std::vector<TagCorners>{} : out;
  }
  std::optional<std::vector<Place>> find_board(const Picture&) const override { return std::nullopt; }
  CalibratedLens calibrate(std::span<const std::vector<Place>>, int, int) const override { return {}; }
  std::string png(const Picture&, std::span<const TagCorners>) const override { return {}; }

  bool blind{false};
  bool twins{false};
  bool baseless{false};
  int copies{1};     // of every picture
  int unstamped{0};  // pictures at the end

 private:
  class Source : public PictureSource {
   public:
    Source(const film::Scene& scene, const film::Motion& motion, int copies, int unstamped)
        : scene_(scene), renderer_(scene, motion), copies_(copies), unstamped_(unstamped) {}
    bool next(Picture& picture) override {
      if (number_ >= scene_.rate * scene_.duration) return false;
      picture.time = number_ / scene_.rate;
      picture.width = scene_.width;
      picture.height = scene_.height;
      picture.grey = renderer_.render((number_ - number_ % copies_) / scene_.rate, number_ - number_ % copies_);
      ++number_;
      if (number_ > std::ceil(scene_.rate * scene_.duration) - unstamped_) picture.time = std::nan("");
      return true;
    }
    int quarter_turns() const override { return scene_.quarter_turns; }

   private:
    film::Scene scene_;
    film::Renderer renderer_;
    int copies_;
    int unstamped_;
    int number_ = 0;
  };

  [[nodiscard]] TagCorners outline(int id, double x, double y, double angle) const {
    TagCorners out{.id = id};
    for (std::size_t k = 0; k < 4; ++k) {
      const double u = k == 0 || k == 3 ? -4.0 : 4.0;
      const double v = k < 2 ? -4.0 : 4.0;
      const double px = x + u * std::cos(angle) + v * std::sin(angle) - scene_.middle[0];
      const double py = y - u * std::sin(angle) + v * std::cos(angle) - scene_.middle[1];
      out.corners[k] = {0.5 * (scene_.width - 1) + 5.0 * px + 0.7 * std::sin(3.0 * static_cast<double>(k)),
                        0.5 * (scene_.height - 1) + 5.0 * py + 0.7 * std::cos(5.0 * static_cast<double>(k))};
    }
    return out;
  }

  film::Scene scene_;
  film::Motion motion_;
};

struct Errors {
  double mean{};
  double rms{};
  double stated{};
};

// Of the tip, degrees. Angles of the renderer open counterclockwise as seen.
Errors errors_of(const FingerMotion& motion, const film::Motion& truth) {
  Errors out;
  const auto& samples = motion.tags.back().samples;
  for (const AngleSample& each : samples) {
    const auto [first, second] = truth.at(each.time);
    const double error = (-each.angle - first - second) / degree;
    out.mean += error / static_cast<double>(samples.size());
    out.rms += error * error / static_cast<double>(samples.size());
    out.stated += std::pow(each.sigma / degree, 2) / static_cast<double>(samples.size());
  }
  out.rms = std::sqrt(out.rms);
  out.stated = std::sqrt(out.stated);
  return out;
}

TEST(TrackedFilm, ReadsAFingerThatTurnsToAFiftiethOfADegree) {
  const film::Scene scene = small_scene();
  const film::Motion truth = turning(0.2, 3.0);
  const TrackedFilm film = track_film(Drawn(scene, truth), "film");
  EXPECT_EQ(film.pictures, 24U);
  EXPECT_EQ(film.doubled, 0U);
  const Errors errors = errors_of(finger_motion(film), truth);
  // 400 px of edges of 150 grey under a noise of 2: 0.003 degrees; the renderer's 24 samples a pixel make it 0.02.
  EXPECT_LT(errors.rms, 0.04);
  EXPECT_GT(errors.stated, 0.004);
  EXPECT_LT(errors.stated, 0.06);
}

// Without the correction, rows that follow each other within 12 ms skew the tag by degrees.
TEST(TrackedFilm, UndoesARollingShutterThatItWasNotToldOf) {
  film::Scene scene = small_scene();
  scene.readout = 12e-3;
  // To and fro: at a constant speed, skew could be the camera's.
  film::Motion truth;
  for (int i = 0; i <= 200; ++i) {
    const double angle = 0.2 - 0.15 * std::cos(62.8 * 5e-4 * i);
    truth.times.push_back(5e-4 * i);
    truth.angles.push_back({0.5 * angle, 0.5 * angle});
  }
  // However the camera was held, and whatever of it the container has turned.
  for (scene.quarter_turns = 0; scene.quarter_turns < 4; ++scene.quarter_turns) {
    const TrackedFilm film = track_film(Drawn(scene, truth), "film");
    const FingerMotion motion = finger_motion(film);
    EXPECT_NEAR(motion.readout.value, 12e-3, 0.6e-3) << scene.quarter_turns;
    EXPECT_LT(errors_of(motion, truth).rms, 0.15) << scene.quarter_turns;
    EXPECT_GT(errors_of(finger_motion(film, {.readout = 0.0}), truth).rms, 0.25) << scene.quarter_turns;
  }
}

// Then a tag's velocity is linear over the picture, as the skew of an oblique view is.
TEST(TrackedFilm, FindsNoRollingShutterInAMotionToOneSideAtOneSpeed) {
  struct Case {
    double rate;     // rad/s
    double tilt;     // degrees
    double readout;  // s
  };
  for (const auto& [rate, tilt, readout] : {Case{9.0, 0.0, 0.0}, Case{9.0, 10.0, 0.0}, Case{3.0, 0.0, 12e-3}}) {
    film::Scene scene = small_scene();
    scene.tilt = {0.0, tilt * degree};
    scene.readout = readout;
    const FingerMotion motion = finger_motion(track_film(Drawn(scene, turning(0.1, rate)), "film"));
    EXPECT_EQ(motion.readout.value, 0.0) << rate << ' ' << tilt << ' ' << readout;
    // Nor does it say that there is none.
    EXPECT_GT(motion.readout.least_seen(), 1.0 / scene.rate) << rate << ' ' << tilt << ' ' << readout;
  }
}

TEST(TrackedFilm, CountsPicturesWithoutATimeStamp) {
  Drawn drawn(small_scene(), turning(0.2, 3.0));
  drawn.unstamped = 2;
  const TrackedFilm film = track_film(drawn, "film");
  EXPECT_EQ(film.pictures, 22U);
  EXPECT_EQ(film.unstamped, 2U);
}

TEST(TrackedFilm, TellsTheExposureByTheBlur) {
  film::Scene scene = small_scene();
  scene.exposure = 3e-3;
  // Faster and faster: the blur of the motion grows with its square.
  film::Motion truth;
  for (int i = 0; i <= 100; ++i) {
    const double time = 1e-3 * i;
    truth.times.push_back(time);
    truth.angles.push_back({45.0 * time * time, 45.0 * time * time});
  }
  const FingerMotion motion = finger_motion(track_film(Drawn(scene, truth), "film"));
  EXPECT_NEAR(motion.exposure.value, 3e-3, 0.5e-3);
}

TEST(TrackedFilm, UndoesAnObliqueView) {
  film::Scene scene = small_scene();
  scene.tilt = {0.0, 12.0 * degree};
  scene.focal = 329.6;  // about the usual lens of a picture of this size
  const film::Motion truth = turning(0.1, 9.0);
  // The outlines of Drawn do not know of the tilt, and are up to 3 px off: the fit must do without.
  const FingerMotion motion = finger_motion(track_film(Drawn(scene, truth), "film"));
  EXPECT_NEAR(motion.tilt / degree, 12.0, 2.0);
}

// The lens sees 39 degrees and not the usual 65: of the renderer's scenes 0 and 16 degrees off.
TEST(TrackedFilm, SaysHowFarAnObliqueViewOfAnUnknownLensMayBeOff) {
  film::Scene scene = small_scene();
  scene.duration = 0.05;
  const film::Motion truth = turning(0.1, 9.0);
  const FingerMotion straight = finger_motion(track_film(Drawn(scene, truth), "film"));
  EXPECT_LT(straight.view_bias / degree, 0.2);
  for (const double tilt : {16.0, -16.0, 10.0}) {
    scene.tilt = {0.0, tilt * degree};
    const TrackedFilm film = track_film(Drawn(scene, truth), "film");
    const FingerMotion unknown = finger_motion(film);
    const double bias = std::abs(errors_of(unknown, truth).mean);
    EXPECT_GT(unknown.view_bias / degree, bias) << tilt;
    EXPECT_LT(unknown.view_bias / degree, 3.0 * bias) << tilt;
    const Lens lens{.width = 280, .height = 420, .focal = {600.0, 600.0}, .centre = {139.5, 209.5}};
    const FingerMotion known = finger_motion(film, {.lens = lens});
    EXPECT_LT(known.view_bias / degree, 0.1) << tilt;
    EXPECT_LT(std::abs(errors_of(known, truth).mean), 0.2) << tilt;
  }
}

// A swing, of films of unlike kinds. What is stated is the error's to a quarter; the error of 60
// samples is known to a tenth.
TEST(TrackedFilm, StatesTheErrorsThatItMakes) {
  film::Motion truth;
  for (int i = 0; i <= 800; ++i) {
    const double angle = 0.35 - 0.3 * std::cos(12.0 * 1e-3 * i);
    truth.times.push_back(1e-3 * i);
    truth.angles.push_back({0.5 * angle, 0.5 * angle});
  }
  const auto check = [&](const char* kind, auto&& change) {
    film::Scene scene = small_scene();
    scene.rate = 120.0;
    scene.duration = 0.5;
    change(scene);
    const Errors errors = errors_of(finger_motion(track_film(Drawn(scene, truth), "film"), {.readout = 0.0}), truth);
    const double noise = std::sqrt(errors.rms * errors.rms - errors.mean * errors.mean);
    EXPECT_GT(errors.stated, 0.8 * noise) << kind << ' ' << noise;
    EXPECT_LT(errors.stated, 1.4 * noise) << kind << ' ' << noise;
  };
  check("quiet", [](film::Scene& scene) { scene.noise = 0.3; });
  check("noisy", [](film::Scene& scene) { scene.noise = 12.0; });
  check("out of focus", [](film::Scene& scene) { scene.optics = 1.3; });
  check("overexposed", [](film::Scene& scene) { scene.white = 275.0; });
  check("at rest", [&](film::Scene& scene) {
    truth.angles.assign(truth.angles.size(), {0.1, 0.13});
    scene.noise = 4.0;
  });
}

TEST(TrackedFilm, LeavesOutPicturesThatRepeatTheOneBefore) {
  Drawn drawn(small_scene(), turning(0.2, 3.0));
  drawn.copies = 2;
  const TrackedFilm film = track_film(drawn, "film");
  EXPECT_EQ(film.doubled, 12U);
  EXPECT_EQ(film.frames.size(), 12U);
}

TEST(TrackedFilm, SaysInOneLineWhatAFilmLacks) {
  film::Scene scene = small_scene();
  scene.duration = 0.02;
  const auto fault = [&](auto&& change) {
    Drawn drawn(scene, turning(0.2, 3.0));
    change(drawn);
    try {
      static_cast<void>(finger_motion(track_film(drawn, "film.mp4")));
    } catch (const text::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(fault([](Drawn& drawn) { drawn.blind = true; }),
            "film.mp4: must show a tag of `coilwright tag`; none was found: light it, hold it in focus, at least 15 px "
            "wide");
  EXPECT_EQ(fault([](Drawn& drawn) { drawn.twins = true; }),
            "film.mp4: must show each tag once; tag 1 is there twice in one picture");
  EXPECT_EQ(fault([](Drawn& drawn) { drawn.baseless = true; }),
            "film.mp4: must show the base's tag, number 0, against which angles are taken; it was never read");
  EXPECT_EQ(fault([](Drawn& drawn) { drawn.copies = 9; }),
            "film.mp4: must be a film; its 5 pictures are one and the same");
}

}  // namespace
}  // namespace coilwright::video
