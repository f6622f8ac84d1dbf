package tompkins.ui.file;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Takes files that are dropped on the window. */
@SuppressWarnings("serial") // never written to a stream
public final class FileDrop extends TransferHandler {

    private final transient Consumer<List<Path>> taker;

    /** A handler that gives the dropped files to {@code taker}, on the event thread. */
    public FileDrop(Consumer<List<Path>> taker) {
        this.taker = taker;
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!canImport(support)) {
            return false;
        }
        try {
            List<Path> files = new ArrayList<>();
            List<?> dropped = (List<?>) support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            dropped.forEach(file -> files.add(((File) file).toPath()));
            if (!files.isEmpty()) {
                taker.accept(files);
            }
            return !files.isEmpty();
        } catch (UnsupportedFlavorException | IOException notFiles) {
            return false;
        }
    }
}
