#pragma once

namespace wavecurve::verification {

/// The publication under test, as its title page has it.
struct Publication {
  const char* title = "Cartoon Animation and Morphing with Wavelet Curve Descriptor";
  const char* authors = "Gene C.-H. Chuang and C.-C. Jay Kuo";
  const char* year = "1996";
  const char* dates = "Received February 5, 1996; revised March 20, 1996";
};

}  // namespace wavecurve::verification
