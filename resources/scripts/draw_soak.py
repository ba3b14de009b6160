#!/usr/bin/env python3
"""Draws what window_soak measured: draw_soak.py soak.csv docs/pictures/soak.png

Above the memory, then how long frames took (the longest of each second, by what went on), and how long the same
small work took the machine beside them; below open descriptors and threads. Prints the longest frame of each occupation.
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLORS = {"playing": "#2f7fc1", "a drag": "#c1692f", "two views": "#5c9e31", "a recording": "#8a4fbf",
          "a job": "#888888"}
LATE_MS = 100


def read(path):
    with open(path, newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    for row in rows:
        for key in row:
            if key != "occupation":
                row[key] = float(row[key])
    return rows


def draw(rows, path):
    minutes = [row["seconds"] / 60 for row in rows]
    figure, (memory, frames, machine, counts) = plt.subplots(
        4, 1, sharex=True, figsize=(10, 9), height_ratios=[2, 3, 1.4, 1.4], layout="constrained")
    for key, color, label in [("resident_mb", "#aaaaaa", "resident"), ("own_mb", "#444444", "without files"),
                              ("allocated_mb", "#2f7fc1", "allocated")]:
        memory.plot(minutes, [row[key] for row in rows], color=color, linewidth=0.8, label=label)
    memory.set_ylabel("memory (MB)")
    memory.legend(loc="lower right", ncols=3, frameon=False)
    memory.set_ylim(0, 1.15 * max(row["resident_mb"] for row in rows))
    for name, color in COLORS.items():
        chosen = [row for row in rows if row["occupation"] == name and row["longest_ms"] > 0]
        frames.scatter([row["seconds"] / 60 for row in chosen], [row["longest_ms"] for row in chosen],
                       s=4, color=color, label=name)
    frames.axhline(LATE_MS, color="#999999", linewidth=0.8)
    frames.set_ylabel("longest frame of a second (ms)")
    frames.set_yscale("log")
    frames.set_ylim(top=2 * max(row["longest_ms"] for row in rows))  # Room for the legend.
    frames.legend(loc="upper right", ncols=len(COLORS), frameon=False, markerscale=3)
    calm = [row for row in rows if row["occupation"] == "playing" and row["work_us"] > 0]
    machine.scatter([row["seconds"] / 60 for row in calm], [row["work_us"] for row in calm], s=4, color="#444444")
    machine.set_ylabel("the same work (µs)")
    machine.set_ylim(0, None)
    counts.plot(minutes, [row["descriptors"] for row in rows], color="#2f7fc1", label="open descriptors")
    counts.plot(minutes, [row["threads"] for row in rows], color="#c1692f", label="threads")
    counts.set_ylim(0, None)
    counts.legend(loc="lower right", ncols=2, frameon=False)
    counts.set_xlabel("minutes")
    for axes in (memory, frames, machine, counts):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=110)


def main():
    rows = read(sys.argv[1])
    draw(rows, sys.argv[2])
    for name in COLORS:
        chosen = [row for row in rows if row["occupation"] == name]
        if chosen:
            print(f"{name}: {len(chosen)} s, longest frame {max(row['longest_ms'] for row in chosen):.0f} ms, "
                  f"memory {chosen[0]['resident_mb']:.1f} to {chosen[-1]['resident_mb']:.1f} MB")


if __name__ == "__main__":
    main()
