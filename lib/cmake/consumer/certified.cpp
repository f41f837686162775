#include <wavecurve/certified/find_filter.hpp>

int main() { return wavecurve::certified::find_filter("D8").name == "db4" ? 0 : 1; }
