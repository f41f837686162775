#include <wavecurve/filters/find_filter_bank.hpp>

int main() { return wavecurve::find_filter_bank<double>("D8").analysis_low.size() == 8 ? 0 : 1; }
