package tompkins.ui.file;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Takes files that are dropped on the window. */
@SuppressWarnings("serial") // never written to a stream
public final class FileDrop extends TransferHandler {

    private final transient Consumer<File> taker;

    /** A handler that gives the dropped file, the first of several, to {@code taker}, on the event thread. */
    public FileDrop(Consumer<File> taker) {
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
            List<?> dropped = (List<?>) support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            dropped.stream().limit(1).forEach(file -> taker.accept((File) file));
            return !dropped.isEmpty();
        } catch (UnsupportedFlavorException | IOException notFiles) {
            return false;
        }
    }
}
