package tompkins.ray;

/**
 * What a file beside the scene file holds, after it was read. Scene files name it, or include the bytes of the file.
 */
public interface FileContent {

    /** The file's name, as the scene file writes it. */
    String name();

    /** A copy of the file's bytes; empty if there were too many to keep, so that scene files can only name the file. */
    byte[] file();

    /** The number of these bytes; 0 if they are not kept. */
    int length();
}
