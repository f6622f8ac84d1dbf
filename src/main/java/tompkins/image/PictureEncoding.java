package tompkins.image;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import tompkins.file.FileException;

/** The encodings of pictures that are read, told apart by the first bytes of the file and not by its name. */
enum PictureEncoding {
    PNG("PNG", "\u0089PNG\r\n\u001a\n"),
    JPEG("JPEG", "\u00ff\u00d8\u00ff"),
    GIF("GIF", "GIF87a", "GIF89a"),
    BMP("BMP", "BM"),
    TIFF("TIFF", "II*\0", "MM\0*", "II+\0", "MM\0+"),
    HDR("Radiance", "#?");

    /** As many bytes as the longest of the beginnings. */
    static final int LONGEST_START = 8;

    /** The encodings that are read, for messages. */
    static final String ALLOWED = "PNG, JPEG, TIFF and Radiance HDR";

    private final String label;
    private final List<byte[]> starts;

    PictureEncoding(String label, String... starts) {
        this.label = label;
        this.starts = Stream.of(starts)
                .map(start -> start.getBytes(StandardCharsets.ISO_8859_1))
                .toList();
    }

    /** The encoding of a file that begins with these bytes; empty if it is none of these. */
    static Optional<PictureEncoding> of(byte[] file) {
        return Stream.of(values()).filter(encoding -> encoding.begins(file)).findFirst();
    }

    /** The name of the encoding, for messages. */
    String label() {
        return label;
    }

    /**
     * Refuses a picture of a kind that is not read.
     *
     * @param known whether it is of another kind
     * @param name the file's name
     * @param property what is not read, such as "has 12 bits a sample"
     * @param allowed what pictures of this encoding must do instead, such as "have 8 or 16"
     */
    void require(boolean known, String name, String property, String allowed) throws FileException {
        if (!known) {
            throw new FileException(name + ": " + property + "; a " + label + " picture must " + allowed
                    + "; convert it, for example with ImageMagick or GIMP");
        }
    }

    private boolean begins(byte[] file) {
        return starts.stream()
                .anyMatch(start ->
                        file.length >= start.length && Arrays.equals(file, 0, start.length, start, 0, start.length));
    }
}
