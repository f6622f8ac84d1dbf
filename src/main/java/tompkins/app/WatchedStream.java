package tompkins.app;

import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;

/** Passes on what the program prints, and remembers why that failed; a print writer only knows that it failed. */
final class WatchedStream extends OutputStream {

    private final OutputStream stream;
    private IOException failure;

    WatchedStream(OutputStream stream) {
        this.stream = stream;
    }

    @Override
    public void write(int single) throws IOException {
        write(new byte[] {(byte) single}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
        try {
            stream.write(bytes, offset, length);
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
