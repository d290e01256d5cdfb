#include <cstdlib>
#include <limits>
#include <new>
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "coilwright/video/tag_pattern.hpp"
#include "coilwright/video/vision.hpp"

namespace coilwright::video {
namespace {

// What OpenCV throws has several lines and names of its sources.
template <class Work>
auto in_one_line(Work&& work) {
  try {
    return work();
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
    throw std::runtime_error("OpenCV refuses it: " + error.err);
  }
}

cv::Mat grey_of(const Picture& picture) {
  return {picture.height, picture.width, CV_8UC1, const_cast<std::uint8_t*>(picture.grey.data())};
}

class FilmFile : public PictureSource {
 public:
  explicit FilmFile(const std::filesystem::path& file) {
    if (!capture_.open(file.string(), cv::CAP_FFMPEG))
      throw std::runtime_error("must be a film that FFmpeg can read; it has no pictures, or is damaged");
  }

  bool next(Picture& picture) override {
    return in_one_line([&] {
      if (!capture_.read(colours_) || colours_.empty()) return false;
      picture.width = colours_.cols;
      picture.height = colours_.rows;
      picture.grey.resize(colours_.total());
      cv::Mat grey = grey_of(picture);
      if (colours_.channels() == 1)
        colours_.copyTo(grey);
      else
        cv::cvtColor(colours_, grey, cv::COLOR_BGR2GRAY);
      picture.time = 1e-3 * capture_.get(cv::CAP_PROP_POS_MSEC);
      // OpenCV 4.6 gives no stamp (0) to the few last pictures, which the decoder holds back.
      if (!first_ && picture.time == 0.0) picture.time = std::numeric_limits<double>::quiet_NaN();
      first_ = false;
      return true;
    });
  }

  [[nodiscard]] int quarter_turns() const override {
    const int quarters = cvRound(capture_.get(cv::CAP_PROP_ORIENTATION_META) / 90.0);
    return ((quarters % 4) + 4) % 4;
  }

 private:
  cv::VideoCapture capture_;
  cv::Mat colours_;
  bool first_ = true;
};

class OpenCv : public Vision {
 public:
  OpenCv() : tags_(cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50)) {
    // FFmpeg tells every damaged block on standard error.
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    setenv("OPENCV_LOG_LEVEL", "SILENT", 0);
    parameters_->errorCorrectionRate = 0.0;  // what reads as another tag is none
  }

  std::unique_ptr<PictureSource> open(const std::filesystem::path& file) const override {
    return in_one_line([&] { return std::make_unique<FilmFile>(file); });
  }

  std::vector<TagCorners> find_tags(const Picture& picture, const Area& area) const override {
    return in_one_line([&] {
      std::vector<std::vector<cv::Point2f>> corners;
      std::vector<int> ids;
      const cv::Mat part = grey_of(picture)({area.left, area.top, area.width, area.height});
      cv::aruco::detectMarkers(part, tags_, corners, ids, parameters_);
      std::vector<TagCorners> out;
      for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] >= tag_count) continue;
        TagCorners tag{.id = ids[i]};
        for (std::size_t k = 0; k < 4; ++k)
          tag.corners[k] = {corners[i][k].x + static_cast<float>(area.left),
                            corners[i][k].y + static_cast<float>(area.top)};
        out.push_back(tag);
      }
      return out;
    });
  }

  std::optional<std::vector<Place>> find_board(const Picture& picture) const override {
    return in_one_line([&]() -> std::optional<std::vector<Place>> {
      const cv::Mat grey = grey_of(picture);
      std::vector<cv::Point2f> corners;
      if (!cv::findChessboardCorners(grey, {board_columns, board_rows}, corners,
                                     cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_FAST_CHECK))
        return std::nullopt;
      cv::cornerSubPix(grey, corners, {5, 5}, {-1, -1}, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 1e-3});
      std::vector<Place> out;
      for (const cv::Point2f& each : corners) out.emplace_back(each.x, each.y);
      return out;
    });
  }

  CalibratedLens calibrate(std::span<const std::vector<Place>> boards, int width, int height) const override {
    return in_one_line([&] {
      std::vector<cv::Point3f> board;
      for (int row = 0; row < board_rows; ++row)
        for (int column = 0; column < board_columns; ++column)
          board.emplace_back(static_cast<float>(column * board_square), static_cast<float>(row * board_square), 0.0F);
      std::vector<std::vector<cv::Point2f>> seen;
      for (const auto& each : boards) {
        auto& points = seen.emplace_back();
        for (const Place& place : each)
          points.emplace_back(static_cast<float>(place.x()), static_cast<float>(place.y()));
      }
      const std::vector<std::vector<cv::Point3f>> objects(seen.size(), board);
      cv::Mat camera = cv::Mat::eye(3, 3, CV_64F);
      cv::Mat distortion;
      std::vector<cv::Mat> turns;
      std::vector<cv::Mat> shifts;
      // A third radial number is not determined by a hand-held board.
      const double rms = cv::calibrateCamera(objects, seen, {width, height}, camera, distortion, turns, shifts,
                                             cv::CALIB_FIX_K3 | cv::CALIB_FIX_ASPECT_RATIO);
      CalibratedLens out{.lens = {.width = width,
                                  .height = height,
                                  .focal = {camera.at<double>(0, 0), camera.at<double>(1, 1)},
                                  .centre = {camera.at<double>(0, 2), camera.at<double>(1, 2)}},
                         .rms = rms};
      for (int k = 0; k < 5; ++k) out.lens.distortion[k] = distortion.at<double>(k);
      return out;
    });
  }

  std::string png(const Picture& picture, std::span<const TagCorners> tags) const override {
    return in_one_line([&] {
      cv::Mat drawn;
      cv::cvtColor(grey_of(picture), drawn, cv::COLOR_GRAY2BGR);
      for (const TagCorners& tag : tags) {
        std::vector<cv::Point> outline;
        for (const Place& corner : tag.corners) outline.emplace_back(cvRound(corner.x()), cvRound(corner.y()));
        cv::polylines(drawn, outline, true, {0, 200, 0}, 2, cv::LINE_AA);
        cv::putText(drawn, std::to_string(tag.id), outline[0], cv::FONT_HERSHEY_SIMPLEX, 0.6, {0, 0, 255}, 2);
      }
      std::vector<unsigned char> bytes;
      cv::imencode(".png", drawn, bytes);
      return std::string(bytes.begin(), bytes.end());
    });
  }

 private:
  cv::Ptr<cv::aruco::Dictionary> tags_;
  cv::Ptr<cv::aruco::DetectorParameters> parameters_ = cv::aruco::DetectorParameters::create();
};

}  // namespace
}  // namespace coilwright::video

extern "C" const coilwright::video::Vision* coilwright_vision() {
  static const coilwright::video::OpenCv vision;
  return &vision;
}
