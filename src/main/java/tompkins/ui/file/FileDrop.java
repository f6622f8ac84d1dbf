package tompkins.ui.file;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Reads files that are dropped on the window. They are copied, and stay where they are. */
@SuppressWarnings("serial") // never written to a stream
public final class FileDrop extends TransferHandler {

    private final transient Consumer<List<File>> taker;

    /** A handler that gives the dropped files, which are at least one, to {@code taker}, on the event thread. */
    public FileDrop(Consumer<List<File>> taker) {
        this.taker = taker;
    }

    @Override
    public boolean canImport(TransferSupport support) {
        if (!support.isDataFlavorSupported(DataFlavor.javaFileListFlavor)) {
            return false;
        }
        if (support.isDrop()) {
            if ((support.getSourceDropActions() & COPY) == 0) {
                return false;
            }
            // whoever lets a file be moved may delete it afterwards
            support.setDropAction(COPY);
        }
        return true;
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!canImport(support)) {
            return false;
        }
        try {
            List<?> dropped = (List<?>) support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
            if (!dropped.isEmpty()) {
                taker.accept(dropped.stream().map(File.class::cast).toList());
            }
            return !dropped.isEmpty();
        } catch (UnsupportedFlavorException | IOException notFiles) {
            return false;
        }
    }
}
