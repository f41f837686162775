#include <wavecurve/io/load_filter.hpp>

int main() { return wavecurve::io::load_filter_bank("D8").vanishing_moments == 4 ? 0 : 1; }
