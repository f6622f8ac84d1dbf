package tompkins.app;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;

/** Passes on what the program prints, and remembers why that failed; a print writer only knows that it failed. */
final class WatchedStream extends FilterOutputStream {

    private IOException failure;

    WatchedStream(OutputStream stream) {
        super(stream);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
        try {
            out.write(bytes, offset, length);
        } catch (IOException lost) {
            failure = lost;
            throw lost;
        }
    }

    /** The latest failure, or null if nothing was lost, or the reader wanted no more, as with {@code | head -1}. */
    IOException failure() {
        boolean closedPipe = failure != null
                && failure.getMessage() != null
                && failure.getMessage().toLowerCase(Locale.ROOT).contains("pipe");
        return closedPipe ? null : failure;
    }
}
