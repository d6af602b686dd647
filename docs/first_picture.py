"""Draw the picture of the README, ``docs/impact.png``: ``python docs/first_picture.py``."""

from pathlib import Path

import matplotlib.pyplot as plt

import nonsmooth as ns
from nonsmooth.report.scenes.gallery import page_of, show

if __name__ == "__main__":
    plt.switch_backend("Agg")
    show(page_of(ns.scene("impact")()), "plane", "jump", "times")
    plt.savefig(Path(__file__).with_name("impact.png"), dpi=100)
