package tompkins.image;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The samples of a TIFF picture that lie together: those of one pixel, one of them if each has a plane of its own, or
 * those of a few pixels that share their chrominance (TIFF 6.0, section 21): first a luminance for each pixel, row
 * after row, then the chrominance.
 *
 * @param across pixels of a block, side by side
 * @param down pixels of a block, one below the other
 * @param bits the bits of each sample
 * @param channels which channel each sample is; -1 for those that do not belong to the colour
 * @param luminances how many of the samples belong to one pixel each, not to all pixels of the block
 */
record TiffBlock(int across, int down, int[] bits, int[] channels, int luminances) {

    private static final int PLANES = 2;
    private static final List<Integer> ALLOWED = List.of(1, 2, 4);

    /**
     * The kinds of block in a file: one, or one for each plane.
     *
     * @param channels which channel each sample of a pixel is
     * @throws FileException if the chrominance is shared in a way that is not read
     */
    static List<TiffBlock> all(TiffDirectory directory, TiffKind kind, int[] channels, String name) throws IOException {
        boolean planes = directory.number(TIFF.TAG_PLANAR_CONFIGURATION, 1) == PLANES;
        int[] shared = sharedChrominance(directory, kind, planes, name);
        if (planes) {
            List<TiffBlock> blocks = new ArrayList<>();
            for (int sample = 0; sample < channels.length; sample++) {
                boolean chrominance = channels[sample] == 1 || channels[sample] == 2;
                blocks.add(new TiffBlock(
                        chrominance ? shared[0] : 1,
                        chrominance ? shared[1] : 1,
                        new int[] {kind.bits()[sample]},
                        new int[] {channels[sample]},
                        0));
            }
            return blocks;
        }
        int pixels = shared[0] * shared[1];
        if (pixels == 1) {
            return List.of(new TiffBlock(1, 1, kind.bits(), channels, 0));
        }
        if (channels.length != TiffKind.Colours.LUMINANCE_AND_CHROMINANCE.samples()) {
            throw new FileException(name + ": has " + channels.length + " samples a pixel;"
                    + " a TIFF picture whose pixels share their chrominance must have 3");
        }
        int[] bits = new int[pixels + 2];
        Arrays.fill(bits, kind.bits()[0]);
        int[] channelOf = new int[pixels + 2];
        channelOf[pixels] = 1;
        channelOf[pixels + 1] = 2;
        return List.of(new TiffBlock(shared[0], shared[1], bits, channelOf, pixels));
    }

    /** How many pixels share their chrominance, across and down; JPEG has that inside. */
    private static int[] sharedChrominance(TiffDirectory directory, TiffKind kind, boolean planes, String name)
            throws IOException {
        if (kind.colours() != TiffKind.Colours.LUMINANCE_AND_CHROMINANCE || kind.isJpeg() && !planes) {
            return new int[] {1, 1};
        }
        long[] told = directory.numbers(TIFF.TAG_YCBCR_SUB_SAMPLING);
        int across = told.length < 2 ? 2 : (int) told[0];
        int down = told.length < 2 ? 2 : (int) told[1];
        if (!ALLOWED.contains(across) || !ALLOWED.contains(down)) {
            throw new FileException(name + ": its chrominance is shared by " + across + " x " + down
                    + " pixels; in a TIFF picture 1, 2 or 4 across and down may share it");
        }
        return new int[] {across, down};
    }
}
