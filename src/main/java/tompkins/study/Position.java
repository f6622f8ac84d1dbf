package tompkins.study;

import tompkins.camera.ConcentricMap;
import tompkins.camera.SamplePositions;

/** Where a sample lies in its pixel, on the lens and in the exposure time; at first in the middle of all. */
final class Position {

    /** Position in the pixel, from 0 to 1. */
    double x = 0.5;

    /** Position in the pixel, from 0 to 1. */
    double y = 0.5;

    /** Position on the lens, in units of its radius. */
    double lensX;

    /** Position on the lens, in units of its radius. */
    double lensY;

    /** The part of the exposure time that has passed, from 0 to 1. */
    double moment = 0.5;

    /** Goes where a sampler has chosen. */
    void goTo(SamplePositions positions, int number) {
        x = positions.x[number] - positions.columns[number];
        y = positions.y[number] - positions.rows[number];
        lensX = positions.lensX[number];
        lensY = positions.lensY[number];
        moment = positions.moments[number];
    }

    /** Puts a sample there. */
    void give(SamplePositions positions, int number) {
        positions.x[number] = positions.columns[number] + x;
        positions.y[number] = positions.rows[number] + y;
        positions.lensX[number] = lensX;
        positions.lensY[number] = lensY;
        positions.moments[number] = moment;
    }

    /** Goes to the point of the lens to which a point of the unit square is mapped. */
    void goToLens(double s, double t) {
        double radius = ConcentricMap.radius(s, t);
        double angle = ConcentricMap.angle(s, t);
        lensX = radius * Math.cos(angle);
        lensY = radius * Math.sin(angle);
    }
}
