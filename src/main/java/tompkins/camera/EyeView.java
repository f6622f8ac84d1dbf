package tompkins.camera;

import tompkins.spacetime.SpaceTimeTransformation;

/**
 * The picture of one eye within that of a camera. In its own pixels it is the ordinary picture of a camera of its own.
 *
 * @param camera the camera of this eye alone
 * @param rays the rays of its picture, in its own pixels
 * @param column the column of the whole picture that is its first
 * @param row the row of the whole picture that is its first
 * @param width pixels in a row
 * @param height number of rows
 */
public record EyeView(Camera camera, CameraRays rays, int column, int row, int width, int height) {

    EyeView(Camera camera, int column, int row, int width, int height, SpaceTimeTransformation sceneFromCamera) {
        this(camera, camera.rays(width, height, sceneFromCamera), column, row, width, height);
    }
}
