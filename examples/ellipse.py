"""How large is the blur of an astigmatic eye at four distances, and along which direction does it lie?"""
import math

import sturm

eye = sturm.Eye(prescription="-2.00 -1.50 x 30 VD 0", pupil_diameter_mm=4)
distances_m = [0.4, 0.8, 6, math.inf]
for distance_m, blur in zip(distances_m, sturm.ellipses(eye, distances_m)):
    print(distance_m, blur["semi_major_rad"], blur["semi_minor_rad"], blur["orientation_deg"])
