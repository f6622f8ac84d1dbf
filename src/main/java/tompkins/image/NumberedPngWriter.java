package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/** A folder of pictures {@code frame0001.png}, ..., which other programs make into a film. */
final class NumberedPngWriter extends AnimationWriter {

    NumberedPngWriter(Path target) throws IOException {
        super(target, PendingFile.folder(target));
    }

    @Override
    void write(BufferedImage frame, PhotographInfo info, int index) throws IOException {
        Path file = pending().path().resolve(String.format(Locale.ROOT, "frame%04d.png", index + 1));
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            PngFile.write(out, frame, info);
        }
    }

    @Override
    void complete(int frames) {
        // Each frame is a complete file.
    }

    @Override
    void abandon() {
        // No stream stays open between frames.
    }
}
