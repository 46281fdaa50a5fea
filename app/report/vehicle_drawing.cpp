#include "app/report/vehicle_drawing.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/report/words.hpp"

namespace railpem::app::report {
namespace {

using diagnosis::Element;

// Millimetres of a drawing 870 wide and 340 high; heights from the top.
constexpr double kBogies[] = {150, 470};
constexpr double kHalfWheelbase = 58;
constexpr double kRailTop = 222, kRailFoot = 232, kRailEnds[] = {14, 606};

std::string rectangle(double x, double y, double width, double height, double radius = 2) {
    return fmt::format("<rect x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" rx=\"{:g}\"/>", x, y, width, height,
                       radius);
}

/// A spring and a damper side by side between two heights.
std::string spring_and_damper(double x, double top, double bottom) {
    const double s = x - 9, d = x + 9, height = bottom - top;
    std::string zigzag = fmt::format("M{:g} {:g}", s, top);
    for (int i = 0; i < 6; ++i)
        zigzag += fmt::format("L{:g} {:.1f}", s + (i % 2 == 0 ? 6 : -6), top + height * (i + 0.5) / 6);
    zigzag += fmt::format("L{:g} {:g}", s, bottom);
    const double middle = top + 0.45 * height;
    return fmt::format(
        "<path class=\"line\" d=\"{0}\"/><path class=\"line\" d=\"M{1:g} {2:g}V{3:g}M{4:g} {3:g}H{5:g}M{4:g} "
        "{6:.1f}V{7:.1f}H{5:g}V{6:.1f}M{1:g} "
        "{7:.1f}V{8:g}\"/>",
        zigzag, d, top, middle, d - 5, d + 5, middle - 3, middle + 8, bottom);
}

template <typename Draw>
std::string per_bogie(const Draw& draw) {
    return draw(kBogies[0]) + draw(kBogies[1]);
}

template <typename Draw>
std::string per_wheel(const Draw& draw) {
    return per_bogie([&](double x) { return draw(x - kHalfWheelbase) + draw(x + kHalfWheelbase); });
}

template <typename Draw>
std::string per_seat(const Draw& draw) {
    std::string out;
    for (double x = 30; x < kRailEnds[1] - 10; x += 37) out += draw(x);
    return out;
}

std::string irregularity() {
    std::string path = fmt::format("M{:g} {:g}", kRailEnds[0], kRailTop - 4);
    for (double x = kRailEnds[0] + 4; x <= kRailEnds[1]; x += 4)
        path += fmt::format("L{:g} {:.1f}", x, kRailTop - 4 - 3 * std::sin(x / 9) - 2 * std::sin(x / 3.7));
    return "<path class=\"line thin\" d=\"" + path + "\"/>";
}

/// The usual places of accelerometers; the front is at the right.
struct Sensor {
    const char* channel;
    double x, y;
};
constexpr Sensor kSensors[] = {{"axlebox_1", 528, 190}, {"axlebox_2", 412, 190},  {"axlebox_3", 208, 190},
                               {"axlebox_4", 92, 190},  {"bogie_1", 536, 130},    {"bogie_2", 216, 130},
                               {"body_front", 470, 92}, {"body_centre", 310, 92}, {"body_rear", 150, 92}};

std::string sensor(const Sensor& at) {
    return fmt::format("<path d=\"M{:g} {:g}l6 6l-6 6l-6 -6z\"/>", at.x, at.y);
}

std::string sensors() {
    std::string out;
    for (const Sensor& at : kSensors) out += sensor(at);
    return out;
}

std::string wheel(double x) {
    return fmt::format("<circle cx=\"{:g}\" cy=\"196\" r=\"25\"/>", x);
}

std::string shapes(Element element) {
    switch (element) {
        case Element::body:
            return "<path d=\"M44 22H560Q592 22 592 62V110H28V38Q28 22 44 22Z\"/>";
        case Element::secondary:
            return per_bogie([](double x) { return spring_and_damper(x, 110, 142); });
        case Element::bogie:
            return per_bogie([](double x) { return rectangle(x - 82, 142, 164, 14, 4); });
        case Element::primary:
            return per_wheel([](double x) { return spring_and_damper(x, 156, 190); });
        case Element::wheel:
            return per_wheel(wheel);
        case Element::contact:
            return per_wheel(
                [](double x) { return fmt::format("<ellipse cx=\"{:g}\" cy=\"221\" rx=\"10\" ry=\"4\"/>", x); });
        case Element::irregularity:
            return irregularity();
        case Element::rail:
            return rectangle(kRailEnds[0], kRailTop, kRailEnds[1] - kRailEnds[0], kRailFoot - kRailTop);
        case Element::pad:
            return per_seat([](double x) { return rectangle(x - 9, kRailFoot, 18, 8); });
        case Element::support:
            return per_seat([](double x) { return rectangle(x - 13, 240, 26, 16); }) +
                   "<path d=\"M14 256H606L620 284H2Z\"/>";
        case Element::sensor:
            return sensors();
    }
    return "";
}

/// Where a label's line begins, in the order of the labels from the top.
struct Anchor {
    Element element;
    double x, y;
};
constexpr auto kAnchors = std::to_array<Anchor>({{Element::body, 590, 60},
                                                 {Element::secondary, 486, 124},
                                                 {Element::sensor, 543, 136},
                                                 {Element::bogie, 552, 149},
                                                 {Element::primary, 544, 170},
                                                 {Element::wheel, 553, 196},
                                                 {Element::irregularity, 604, 217},
                                                 {Element::contact, 538, 221},
                                                 {Element::rail, 606, 228},
                                                 {Element::pad, 594, 236},
                                                 {Element::support, 598, 262}});
// Painted from the back to the front.
constexpr auto kPainted = std::to_array<Element>({Element::support, Element::pad, Element::rail, Element::wheel,
                                                  Element::primary, Element::bogie, Element::secondary, Element::body,
                                                  Element::irregularity, Element::contact, Element::sensor});

/// What is coloured of an element: the sensor or the wheel that an effect names, or all there is of it.
std::string marked_shapes(const diagnosis::Diagnosis& diagnosis, Element element) {
    std::string out;
    for (const diagnosis::NamedEffect& effect : diagnosis.omitted) {
        if (effect.element != element) continue;
        for (const auto& [name, value] : effect.instance.choices) {
            for (const Sensor& at : kSensors)
                if (element == Element::sensor && name == "channel" && value == at.channel) out += sensor(at);
            for (int i = 0; i < 4; ++i)  // from the front
                if (element == Element::wheel && name == "wheel" && value == std::to_string(i + 1))
                    out += wheel(kBogies[i < 2 ? 1 : 0] + (i % 2 == 0 ? kHalfWheelbase : -kHalfWheelbase));
        }
    }
    return out.empty() ? shapes(element) : out;
}

double probability_of(const diagnosis::Diagnosis& diagnosis, Element element) {
    double sum = 0.0;
    for (const diagnosis::PlaceEvidence& place : diagnosis.places)
        if (place.element == element) sum += place.probability;
    return std::isfinite(sum) ? std::min(sum, 1.0) : 0.0;
}

}  // namespace

std::string vehicle_drawing(const diagnosis::Diagnosis& diagnosis) {
    std::string out =
        "<svg class=\"drawing\" viewBox=\"0 0 870 340\" role=\"img\" aria-label=\"Vehicle and track with the places of "
        "the "
        "mismatch\">\n";
    for (const Element element : kPainted) {
        const double p = probability_of(diagnosis, element);
        const std::string name = element_name(element);
        out += fmt::format("<g class=\"part {}\">{}</g>\n", name, shapes(element));
        if (p >= 0.05)
            out += fmt::format("<g class=\"part {} hot\" opacity=\"{:.2f}\">{}</g>\n", name, p,
                               marked_shapes(diagnosis, element));
    }
    for (std::size_t i = 0; i < kAnchors.size(); ++i) {
        const Anchor& anchor = kAnchors[i];
        const double p = probability_of(diagnosis, anchor.element);
        const double y = 20.0 + 30.0 * static_cast<double>(i);
        const char* const kind = p >= 0.1 ? "hot" : "cold";
        out += fmt::format("<path class=\"leader {}\" d=\"M{:g} {:g}L640 {:g}h6\"/>", kind, anchor.x, anchor.y, y);
        out += fmt::format("<text class=\"{}\" x=\"651\" y=\"{:g}\">{}{}</text>\n", kind, y + 5,
                           element_name(anchor.element), p >= 0.005 ? " " + percent(p) : "");
    }
    return out + "</svg>\n";
}

}  // namespace railpem::app::report
