package tompkins.shutter;

/**
 * A shutter model of another jar: a public record with a public constant {@code DEFAULT} and a public constructor
 * without parameters, named in {@code META-INF/services/tompkins.shutter.AddedShutter} (see docs/extending.md).
 */
public non-sealed interface AddedShutter extends Shutter {}
