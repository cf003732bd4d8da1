#include "wavefront/fft/tile_transform.h"

#include <opencv2/core.hpp>

#include "io/images/opencv_view.h"

namespace sturm {

void transform_tile(const Image& tile, Image& spectrum) {
  cv::dft(view(tile), view(spectrum));
}

void tile_of_spectrum(const Image& spectrum, Image& tile) {
  cv::dft(view(spectrum), view(tile), cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
}

void product_of_spectra(const Image& a, const Image& b, Image& product) {
  cv::mulSpectrums(view(a), view(b), view(product), 0);
}

}  // namespace sturm
