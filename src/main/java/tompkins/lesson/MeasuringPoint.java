package tompkins.lesson;

/** A point of a picture at which something is measured, whatever the size of the picture in pixels. */
public sealed interface MeasuringPoint permits PicturePoint, PictureEdge {}
