package tompkins.surface;

/**
 * A surface of another jar: a public record with a public constant {@code DEFAULT} and a public constructor without
 * parameters, named in {@code META-INF/services/tompkins.surface.AddedSurface} (see docs/extending.md).
 */
public non-sealed interface AddedSurface extends Surface {}
