package tompkins.render;

import java.util.Arrays;
import tompkins.camera.EyeView;
import tompkins.camera.PictureRays;
import tompkins.camera.SamplePositions;
import tompkins.ray.Padded;
import tompkins.ray.RayPacket;
import tompkins.trace.BlockSamples;

/**
 * Adds up the samples that a pass takes of a block of pixels, in double precision, and then gives the film their sums.
 * The film has single precision, and would lose the last digits of each of many samples. One for each thread.
 */
final class BlockSums extends Padded {

    private final PixelBuffer buffer;
    private final PictureRays rays;
    private final SamplePositions places = new SamplePositions(RayPacket.MOST);
    private final double[] red = new double[RayPacket.MOST];
    private final double[] green = new double[RayPacket.MOST];
    private final double[] blue = new double[RayPacket.MOST];
    private final double[] squares = new double[RayPacket.MOST];

    /** Number of samples of each pixel. */
    private int taken;

    /** Sums for one film and the rays of its picture. */
    BlockSums(PixelBuffer buffer, PictureRays rays) {
        this.buffer = buffer;
        this.rays = rays;
    }

    /** Begins with the pixels of a block that a pass takes and an eye shows. */
    SamplePositions begin(Pass pass, EyeView eye, Tile block) {
        places.begin(eye);
        places.addPixels(
                block.column(),
                block.row(),
                block.width(),
                block.height(),
                pass.stride(),
                (column, row) -> rays.view(column, row) == eye && pass.takes(column, row, buffer.pixel(column, row)));
        return places;
    }

    /** Adds a sample of each of these pixels. */
    void add(BlockSamples samples) {
        int count = places.count();
        taken++;
        for (int i = 0; i < count; i++) {
            red[i] += samples.red[i];
        }
        for (int i = 0; i < count; i++) {
            green[i] += samples.green[i];
        }
        for (int i = 0; i < count; i++) {
            blue[i] += samples.blue[i];
        }
        for (int i = 0; i < count; i++) {
            squares[i] += Film.squared(samples.red[i], samples.green[i], samples.blue[i]);
        }
    }

    /** Gives the film what was summed up, and starts from 0 again. */
    void addToFilm() {
        for (int i = 0; taken > 0 && i < places.count(); i++) {
            int pixel = buffer.pixel(places.column(i), places.row(i));
            buffer.add(pixel, red[i], green[i], blue[i], squares[i], taken);
        }
        taken = 0;
        Arrays.fill(red, 0);
        Arrays.fill(green, 0);
        Arrays.fill(blue, 0);
        Arrays.fill(squares, 0);
    }
}
