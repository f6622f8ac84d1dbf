package tompkins.ui;

import tompkins.camera.Camera;

/** What the panels ask of any camera. */
final class Cameras {

    private Cameras() {}

    /** The distance of what is in focus in the middle of the picture. */
    static double focusDistance(Camera camera) {
        return camera.focusDistance();
    }
}
