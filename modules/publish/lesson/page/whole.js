// In place of heart.js, for a lesson whose organs cannot be cut open and have no conduction system.
const cut = {on: false}, outerWall = null, chambersOf = [], lit = false, kEcgHigh = 0, cordColors = [], ecgOf = null, nothing = () => {};
const cutting = () => false, opened = cutting, litNow = cutting, isCutAway = cutting, heightOf = () => 0, excitationMs = heightOf, lightOf = heightOf;
const drawnOf = () => surfaces.filter(s => s.on), seenOf = s => s.now, facing = (s, v) => -dot(normalOf(v), ahead);
const setPlane = () => gl.uniform4f(uniform.plane, 0, 0, 0, 1), placeFace = nothing, drawFace = nothing, drawCords = nothing, drawEcg = nothing, faceCut = nothing, showHeart = nothing, setCut = nothing, setBlood = nothing, setConduction = nothing;
function carry() {}
