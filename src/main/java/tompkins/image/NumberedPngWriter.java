package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.OutputFolder;

/**
 * A folder of pictures {@code frame0000.png}, ..., which other programs make into a film; those that are whole stay.
 */
final class NumberedPngWriter extends AnimationWriter {

    private final FrameFolder folder;

    /** Begins to fill a folder. */
    private NumberedPngWriter(Path target, OutputFolder made) {
        super(target, made);
        folder = new FrameFolder(target);
    }

    /**
     * Begins to fill a folder.
     *
     * @throws FileException if there is something in it, or it cannot be made
     */
    static NumberedPngWriter in(Path target) throws IOException {
        OutputFolder made = OutputFolder.at(target);
        try (Stream<Path> content = Files.list(target)) {
            if (content.findAny().isPresent()) {
                throw new FileException(target + ": cannot be written: it exists; name a new or an empty folder");
            }
        }
        return new NumberedPngWriter(target, made);
    }

    @Override
    void write(BufferedImage frame, PhotographInfo info, int index) throws IOException {
        folder.write(index, new FramePicture(frame), info);
    }

    @Override
    Path complete() {
        return folder.folder();
    }
}
