"""Makes stars.csv and star-names.csv from the npm package d3-celestial (BSD-3-Clause licence). Usage:

  npm pack d3-celestial@0.7.35 && tar xzf d3-celestial-0.7.35.tgz && python3 make_stars.py package FOLDER

Stars: XHIP (Anderson, Francis 2012). Names: the cross index of Smith (1996). Needs nothing but Python 3.
"""

import json
import sys

LIMIT = 6.5
NAMES = 30

SOURCE = "d3-celestial 0.7.35, Copyright (c) 2015, Olaf Frohn, BSD-3-Clause licence (META-INF/licences/d3-celestial.txt)."

STARS = """# Stars to magnitude %.1f: right ascension and declination (degrees, ICRS, epoch 2000), V magnitude, colour B-V; brightest first.
# Source: E. Anderson, Ch. Francis, XHIP: An extended Hipparcos compilation, Astronomy Letters 38 (2012) 331 (CDS V/137D),
# after The Hipparcos and Tycho Catalogues (ESA SP-1200, 1997); by way of file data/stars.8.json of
# %s
# B-V of %d stars is unknown and set to 0.6. Made by make_stars.py.
ra,dec,v,bv
"""

TABLE = """# The %d brightest stars of stars.csv: the place there, and the name.
# Source of the names: Smith, FK5-SAO-HD-Common Name Cross Index (1996, CDS IV/22); by way of file data/starnames.json of
# %s
# Made by make_stars.py.
ra,dec,name
"""


def stars(folder):
    """The stars, brightest first, those of one magnitude by right ascension; and how many have no colour."""
    rows = []
    unknown = 0
    with open(folder + "/data/stars.8.json") as file:
        features = json.load(file)["features"]
    for star in features:
        magnitude = float(star["properties"]["mag"])
        if magnitude > LIMIT:
            continue
        ra, dec = star["geometry"]["coordinates"]
        colour = star["properties"]["bv"]
        if colour in ("", None):
            colour = 0.6
            unknown += 1
        # no minus sign before 0.00
        colour = float(colour) if abs(float(colour)) >= 0.005 else 0.0
        rows.append((magnitude, round(ra % 360, 4), round(dec, 4), colour, star["id"]))
    return sorted(rows), unknown


def main(source, target):
    rows, unknown = stars(source)
    with open(source + "/data/starnames.json") as file:
        names = json.load(file)
    with open(target + "/stars.csv", "w", newline="\n") as file:
        file.write(STARS % (LIMIT, SOURCE, unknown))
        for magnitude, ra, dec, colour, _ in rows:
            file.write("%.4f,%.4f,%.2f,%.2f\n" % (ra, dec, magnitude, colour))
    with open(target + "/star-names.csv", "w", newline="\n") as file:
        file.write(TABLE % (NAMES, SOURCE))
        for _, ra, dec, _, number in rows[:NAMES]:
            file.write("%.4f,%.4f,%s\n" % (ra, dec, names[str(number)]["name"]))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
