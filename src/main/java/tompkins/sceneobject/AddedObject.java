package tompkins.sceneobject;

/**
 * An object of another jar: a public record with a public constant {@code DEFAULT} and a public constructor without
 * parameters, named in {@code META-INF/services/tompkins.sceneobject.AddedObject} (see docs/extending.md).
 */
public non-sealed interface AddedObject extends SceneObject {}
