#include "reports/html_head.hpp"

#include "reports/escape.hpp"
#include "reports/stylesheet.hpp"

namespace wavecurve::reports {

std::string html_head(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
         escape(title) + "</title>\n<style>\n" + std::string(stylesheet()) + "</style>\n</head>\n";
}

}  // namespace wavecurve::reports
