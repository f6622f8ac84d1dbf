package tompkins.image;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import tompkins.file.FileException;
import tompkins.file.OutputFolder;

/** A folder of pictures {@code frame0000.png}, ..., which other programs make into a film. */
final class NumberedPngWriter extends AnimationWriter {

    private final FrameFolder folder;
    private final OutputFolder made;

    /**
     * Begins to fill a folder.
     *
     * @throws FileException if there is something in it, or it cannot be made
     */
    NumberedPngWriter(Path target) throws IOException {
        super(target);
        folder = new FrameFolder(target);
        made = OutputFolder.at(target);
        try (Stream<Path> content = Files.list(target)) {
            if (content.findAny().isPresent()) {
                throw new FileException(target + ": cannot be written: it exists; name a new or an empty folder");
            }
        }
    }

    @Override
    void write(BufferedImage frame, PhotographInfo info, int index) throws IOException {
        folder.write(index, new FramePicture(frame), info);
    }

    @Override
    Path complete(int frames) throws IOException {
        made.close();
        return folder.folder();
    }

    @Override
    void discard(int frames) throws IOException {
        for (int frame = 0; frame < frames && !OutputFolder.keepsWholeFiles(); frame++) {
            Files.deleteIfExists(folder.file(frame));
        }
        made.close();
    }
}
