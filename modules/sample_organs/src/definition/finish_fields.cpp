#include "definition/finish_fields.h"

namespace viscera::sample_organs {

Finish finishFrom(Fields& fields) {
  for (const char* known : {"paint", "edge_scale", "mottle"})
    fields.ignore(known);
  Finish finish;
  if (fields.has("paint"))
    finish.paint = fields.vector("paint");
  if (fields.has("edge_scale"))
    finish.edgeScale = fields.positive("edge_scale");
  if (finish.paint && ((finish.paint->array() < 0).any() || (finish.paint->array() > 1).any()))
    fields.fail("paint", "is outside 0 to 1", "divide by 255 when the colour is in bytes");
  if (fields.has("mottle")) {
    Fields part(fields.get("mottle"), fields.where() + ", mottle");
    finish.mottle = Mottle{part.number("amount"), part.positive("wavelength", Mottle{}.wavelength)};
    if (finish.mottle->amount < 0 || finish.mottle->amount > 1)
      part.fail("amount", "is outside 0 to 1", "it is a share of the brightness");
    part.requireNothingElse();
  }
  return finish;
}

} // namespace viscera::sample_organs
