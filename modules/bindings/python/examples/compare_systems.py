"""Every coordinate system on one organ: what it promises, how exact it is, and how long it takes."""

from _example import kidney

import viscera

points, triangles = kidney(10, 14)
handles = viscera.place_handles(points, triangles, 16)
bound = 0
print(f"{'system':24} {'identity':>9} {'least':>8} {'points without':>14} {'seconds':>8}")
for system in viscera.systems():
    if system.traits["needs_tetrahedra"]:
        continue  # seconds each: TetGen fills the handles first
    try:
        report = viscera.bind(points, handles, system, partial=True).report
    except viscera.Error as error:
        print(f"{system.id:24} {error}")
        continue
    bound += 1
    print(f"{system.id:24} {report['identity_error']:9.1e} {report['min_weight']:8.1e} "
          f"{len(report['failures']):14} {report['seconds']:8.3f}")
assert bound > 12
