package tompkins.image;

import com.twelvemonkeys.imageio.metadata.jpeg.JPEG;
import com.twelvemonkeys.imageio.metadata.jpeg.JPEGSegment;
import com.twelvemonkeys.imageio.metadata.jpeg.JPEGSegmentUtil;
import com.twelvemonkeys.imageio.stream.ByteArrayImageInputStream;
import java.io.IOException;
import java.util.Arrays;
import javax.imageio.stream.ImageInputStream;
import tompkins.file.FileException;

/**
 * Reads JPEG pictures (ITU-T T.81): grey, RGB and YCbCr, baseline and progressive. The JDK's reader is asked for the
 * samples as they are stored. Left to itself it converts them by embedded profiles, and takes YCbCr pictures without a
 * marker of JFIF or Adobe for RGB.
 */
final class JpegReader {

    private static final byte[] RGB_COMPONENTS = {'R', 'G', 'B'};

    /** Where a segment of Adobe holds the number of its colours, 0 for RGB, after the name. */
    private static final int ADOBE_TRANSFORM_AT = 5;

    private final String name;
    private Orientation orientation = Orientation.TOP_LEFT;
    private boolean exifSeen;
    private boolean jfif;
    private int adobeTransform = -1;
    private byte[] components = {};

    private JpegReader(String name) {
        this.name = name;
    }

    /**
     * The pixels of a picture.
     *
     * @throws FileException if the picture is of a kind that is not read
     * @throws IOException if the file is damaged
     */
    static Pixels read(byte[] file, String name) throws IOException {
        JpegReader reader = new JpegReader(name);
        try (ImageInputStream stream = new ByteArrayImageInputStream(file)) {
            for (JPEGSegment segment : JPEGSegmentUtil.readSegments(stream, JPEGSegmentUtil.ALL_SEGMENTS)) {
                reader.readSegment(segment);
            }
        }
        if (reader.components.length == 0) {
            throw new IOException("the picture has no pixels");
        }
        Pixels pixels = PixelDecoder.decode(ImageProviders.samples(PictureEncoding.JPEG, file, name), null);
        if (reader.components.length == 3 && !reader.isRgb()) {
            toRgb(pixels.rgba());
        }
        return reader.orientation.turn(pixels);
    }

    private void readSegment(JPEGSegment segment) throws IOException {
        int marker = segment.marker();
        if (marker >= JPEG.SOF0
                        && marker <= JPEG.SOF15
                        && marker != JPEG.DHT
                        && marker != JPEG.DAC
                        && marker != JPEG.SOF0 + 8
                || marker == JPEG.SOF55) {
            readFrame(marker, segment.segmentData().readAllBytes());
        } else if (marker == JPEG.APP0 && "JFIF".equals(segment.identifier())) {
            jfif = true;
        } else if (marker == JPEG.APP14 && "Adobe".equals(segment.identifier())) {
            byte[] data = segment.data().readAllBytes();
            adobeTransform = data.length > ADOBE_TRANSFORM_AT ? data[ADOBE_TRANSFORM_AT] & 0xff : -1;
        } else if (marker == JPEG.APP1 && "Exif".equals(segment.identifier()) && !exifSeen) {
            exifSeen = true;
            byte[] data = segment.data().readAllBytes();
            orientation =
                    TiffDirectory.exifOrientation(Arrays.copyOfRange(data, Math.min(1, data.length), data.length));
        }
    }

    /**
     * A frame: bits of a sample, height, width, and components with three bytes each, the first of which is its name.
     */
    private void readFrame(int marker, byte[] frame) throws IOException {
        PictureEncoding kind = PictureEncoding.JPEG;
        kind.require(marker <= JPEG.SOF2, name, "its coding is " + coding(marker), "be baseline or progressive");
        kind.require(frame[0] == 8, name, "has " + frame[0] + " bits a sample", "have 8");
        // The library has a limit of its own, and no reason.
        Pixels.requireSize(bigEndian(frame, 3), bigEndian(frame, 1), name);
        int count = frame[5] & 0xff;
        String inks = count == 4 ? ", as for printing in cyan, magenta, yellow and black" : "";
        kind.require(
                count == 1 || count == 3, name, "has " + count + " colours" + inks, "be grey or red, green and blue");
        components = new byte[count];
        for (int i = 0; i < count; i++) {
            components[i] = frame[6 + 3 * i];
        }
    }

    private static int bigEndian(byte[] data, int at) {
        return (data[at] & 0xff) << 8 | data[at + 1] & 0xff;
    }

    private static String coding(int marker) {
        return switch (marker) {
            case JPEG.SOF3 -> "lossless";
            case JPEG.SOF5, JPEG.SOF6, JPEG.SOF7 -> "hierarchical";
            case JPEG.SOF55 -> "JPEG-LS";
            default -> "arithmetic";
        };
    }

    /**
     * Decides as the library of the Independent JPEG Group does: by JFIF, then Adobe's marker, then the components'
     * names.
     */
    private boolean isRgb() {
        return !jfif && (adobeTransform >= 0 ? adobeTransform == 0 : Arrays.equals(components, RGB_COMPONENTS));
    }

    /** From luminance and differences (JFIF 1.02, after ITU-R BT.601) to whole levels of red, green and blue. */
    private static void toRgb(float[] rgba) {
        for (int pixel = 0; pixel < rgba.length; pixel += 4) {
            double luminance = 255 * rgba[pixel];
            double blueDifference = 255 * rgba[pixel + 1] - 128;
            double redDifference = 255 * rgba[pixel + 2] - 128;
            rgba[pixel] = level(luminance + 1.402 * redDifference);
            rgba[pixel + 1] = level(luminance - 0.34414 * blueDifference - 0.71414 * redDifference);
            rgba[pixel + 2] = level(luminance + 1.772 * blueDifference);
        }
    }

    private static float level(double number) {
        return Math.round(Math.max(0, Math.min(255, number))) / 255f;
    }
}
