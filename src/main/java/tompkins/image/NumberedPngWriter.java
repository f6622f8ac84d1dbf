package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import tompkins.file.PendingFile;

/** A folder of pictures {@code frame0000.png}, ..., which other programs make into a film. */
final class NumberedPngWriter extends AnimationWriter {

    NumberedPngWriter(PendingFile pending) {
        super(pending);
    }

    @Override
    void write(BufferedImage frame, PhotographInfo info, int index) throws IOException {
        try (OutputStream out = pending().open(FrameFolder.name(index))) {
            PngFile.write(out, frame, info);
        }
    }

    @Override
    void complete(int frames) {
        // Each frame is a complete file.
    }
}
