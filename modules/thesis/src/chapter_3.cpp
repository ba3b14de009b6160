#include "figures.h"
#include "line_figure.h"

namespace viscera::thesis {
namespace {

using enum Expect;

LineFigure figure312() {
  return {"3.12",
          "Voronoi regions, natural neighbour transfer",
          "Coordinates jump where the point is in line with two handles (a sword).",
          kOwnHandles +
              "The line sags like a parabola, exactly through a place from which one inner handle is seen "
              "behind another. The Laguerre weights are shown beside it as the thesis's remedy.",
          {{"natural neighbour transfer",
            "voronoi-regions",
            {{"transfer", "natural-neighbour"}},
            14,
            {jumps},
            true},
           {"Laguerre weights", "voronoi-regions", {{"transfer", "laguerre"}}, 14, {continuous}, true}}};
}

LineFigure figure314() {
  return {
      "3.14",
      "Incremental approach, few inner handles",
      "With two or three inner handles the coordinates are well-defined: positive, continuous and smooth.",
      kOwnHandles,
      {{"incremental approach (10)", "incremental-approach", {}, 10, {everywhere, positive, smooth}},
       {"incremental approach (11)", "incremental-approach", {}, 11, {everywhere, positive, smooth}}}};
}

LineFigure figure315() {
  return {
      "3.15",
      "Incremental approach, many inner handles",
      "With many inner handles some coordinates are negative; k = |d| may be a remedy (proposed, not tried).",
      kOwnHandles + "Whether a coordinate becomes negative depends on where the handles are.",
      {{"k = 1", "incremental-approach", {}, 26, {negative}},
       {"k = |d|", "incremental-approach", {{"k", "norm"}}, 26, {everywhere, positive}}}};
}

LineFigure figure320() {
  return {"3.20",
          "Numerical integration approach",
          "The coordinates are positive and continuous, but have several local maxima and kinks.",
          kOwnHandles,
          {{"numerical integration",
            "numerical-integration",
            {},
            10,
            {everywhere, positive, continuous, severalMaxima, kinks}}}};
}

LineFigure figure323() {
  const auto panel = [](const char* name, const char* partitions, const char* polyhedra) {
    return Panel{name,
                 "catalogue-of-layers",
                 {{"partitions", partitions}, {"polyhedra", polyhedra}},
                 10,
                 {everywhere, positive, kinks}};
  };
  return {"3.23",
          "Catalogue of layers",
          "With mean value coordinates inside, all four catalogues are continuous with kinks at inner faces.",
          kOwnHandles,
          {panel("independent, tetrahedra", "independent", "tetrahedra"),
           panel("nested, tetrahedra", "nested", "tetrahedra"),
           panel("independent, convex polyhedra", "independent", "convex"),
           panel("nested, convex polyhedra", "nested", "convex")}};
}

/// Lagrange minimisation around nine handles.
Panel lagrange(const char* name, const char* target, const char* positivity, std::vector<Expect> expected) {
  return {name,
          "lagrange-minimisation",
          {{"target", target}, {"positivity", positivity}},
          9,
          std::move(expected)};
}

LineFigure figure327() {
  return {"3.27",
          "Lagrange minimisation, three targets",
          "Without constraints the coordinates are smooth; the target 1/d makes some of them negative.",
          kOwnHandles,
          {lagrange("target 1", "one", "free", {smooth}),
           lagrange("target 1/d", "inverse-distance", "free", {smooth, negative}),
           lagrange("target 1 - d/max d", "closeness", "free", {smooth})}};
}

LineFigure figure328() {
  return {"3.28",
          "Lagrange minimisation, local test",
          "Choosing point by point which handles have no influence makes the coordinates jump.",
          kOwnHandles,
          {lagrange("local test, target 1/d", "inverse-distance", "local-test", {positive, jumps})}};
}

LineFigure figure329() {
  return {"3.29",
          "Lagrange minimisation, iterative test",
          "Setting negative numbers to zero again and again gives continuous coordinates with kinks.",
          kOwnHandles,
          {lagrange("iterative test, target 1/d", "inverse-distance", "iterative-test", {positive, kinks})}};
}

LineFigure figure331() {
  Panel raised =
      lagrange("iterative, target raised", "inverse-distance", "iterative", {everywhere, positive, smooth});
  raised.choices.emplace_back("shift", "raised");
  Panel lowered = lagrange("iterative, as printed", "inverse-distance", "iterative", {everywhere, positive});
  lowered.choices.emplace_back("shift", "lowered");
  return {
      "3.31",
      "Iterative Lagrange minimisation",
      "Shifting the target by the most negative number until none is left makes all coordinates positive; it "
      "does not always converge.",
      kOwnHandles + "The formula as printed lowers the target; raising it is what converges here.",
      {raised, lowered}};
}

LineFigure figure334() {
  return {"3.34",
          "Determinants approach",
          "The coordinates are positive and jump where the number of tetrahedra around the point changes.",
          kOwnHandles,
          {{"determinants approach", "determinants-approach", {}, 9, {everywhere, positive, jumps}}}};
}

LineFigure figure336() {
  return {"3.36",
          "Gradient method approach",
          "The coordinates are positive and continuous, with kinks where two of them tie.",
          kOwnHandles,
          {{"gradient method", "gradient-method", {}, 15, {everywhere, positive, kinks}}}};
}

} // namespace

std::vector<Item> chapter3() {
  std::vector<Item> items;
  for (const LineFigure& figure :
       {figure312(), figure314(), figure315(), figure320(), figure323(), figure327(), figure328(),
        figure329(), figure331(), figure334(), figure336()})
    items.push_back(itemOf(figure));
  return items;
}

} // namespace viscera::thesis
